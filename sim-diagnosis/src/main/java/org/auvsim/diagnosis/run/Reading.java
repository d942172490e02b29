package org.auvsim.diagnosis.run;

/**
 * One measured number of a run.
 *
 * @param axis 0 to 2
 */
public record Reading(Channel channel, int sample, int axis) {}
