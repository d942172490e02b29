package org.auvsim.server.simulator;

/**
 * Where in the course of a simulation an input was taken.
 *
 * @param step number of steps made before
 * @param index number of inputs since that step
 * @param duringStep whether the next step had begun and waited
 * @param time the world's time (s)
 */
public record InputPlace(long step, int index, boolean duringStep, double time) {}
