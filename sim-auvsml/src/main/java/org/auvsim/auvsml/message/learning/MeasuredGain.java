package org.auvsim.auvsml.message.learning;

/**
 * Root mean square error of predictions on data that was not used to find the cause; m, rad, m/s or
 * rad/s by channel.
 *
 * @param channel what was measured, as {@code POSITION}
 * @param before as the model was
 * @param after with what was found
 * @param noise of the measurement itself: no model gets below
 */
public record MeasuredGain(String channel, double before, double after, double noise) {}
