/**
 * Searches the causes that explain measured runs. A {@code Search} follows the runs; its {@code
 * Selection} takes one cause or two that a {@code Screening} promises ({@code OneOrTwo}), adds what
 * is missed still ({@code ForwardSelection}), lets sets compete ({@code Tried}, {@code
 * Tournament}), and exchanges what the data cannot tell apart ({@code Exchange}, {@code Choice}).
 */
@NullMarked
package org.auvsim.diagnosis.search;

import org.jspecify.annotations.NullMarked;
