package org.auvsim.diagnosis.cause;

/**
 * A number of a cause; 0 means that the cause is absent.
 *
 * @param unit as in reports
 * @param scale of a change that is small, but can be told
 * @param isOneSided whether only positive values make sense
 */
public record Parameter(String name, String unit, double scale, boolean isOneSided) {}
