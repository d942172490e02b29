package org.auvsim.diagnosis.reading;

/**
 * How much there is in a file.
 *
 * @param rows with something measured
 * @param changes rows that command something anew
 * @param interval the usual time between two rows (s)
 */
record Extent(long rows, long changes, double interval) {}
