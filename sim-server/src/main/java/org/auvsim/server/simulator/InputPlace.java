package org.auvsim.server.simulator;

/**
 * Where in the course of a simulation an input was taken.
 *
 * @param revision how often the past had been corrected or left before
 * @param step number of steps made before
 * @param index number of inputs since that step
 * @param duringStep whether the next step had begun and waited
 * @param time the world's time (s)
 */
public record InputPlace(int revision, long step, int index, boolean duringStep, double time) {}
