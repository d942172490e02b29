/**
 * Searches the causes that explain measured runs. A {@code Search} follows the runs; its {@code
 * Selection} takes what a {@code Screening} promises, lets it compete ({@code Tried}, {@code
 * Tournament}), and exchanges what the data cannot tell apart ({@code Exchange}, {@code Choice}).
 */
@NullMarked
package org.auvsim.diagnosis.search;

import org.jspecify.annotations.NullMarked;
