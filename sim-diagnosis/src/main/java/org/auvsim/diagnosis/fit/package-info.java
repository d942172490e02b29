/**
 * Finds the causes that fit. To read: an {@link org.auvsim.diagnosis.fit.Examination} lets a {@code
 * Search} follow the runs and judges what it finds by held-out ones. Its {@code Selection} takes
 * what a {@code Screening} promises, lets it compete ({@code Tried}, {@code Tournament}, {@code
 * Refinement}), and exchanges what the data cannot tell apart ({@code Exchange}, {@code Choice}).
 */
@NullMarked
package org.auvsim.diagnosis.fit;

import org.jspecify.annotations.NullMarked;
