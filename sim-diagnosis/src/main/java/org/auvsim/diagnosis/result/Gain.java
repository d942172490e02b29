package org.auvsim.diagnosis.result;

/**
 * Root mean square error of predictions against measurements, as the model was believed and with
 * what was found; m, rad, m/s or rad/s by channel.
 *
 * @param noise of the measurement itself: no model gets below
 */
public record Gain(double before, double after, double noise) {}
