package org.auvsim.junit;

/**
 * How near a body came.
 *
 * @param time world time (s) at which it was nearest, for the first time
 * @param distance from its origin (m)
 */
public record Approach(double time, double distance) {}
