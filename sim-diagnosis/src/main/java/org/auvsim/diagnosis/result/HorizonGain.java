package org.auvsim.diagnosis.result;

/**
 * How well held-out runs are predicted some time ahead, from states all along them that the model
 * with what was found is fitted to.
 *
 * @param ahead (s)
 * @param position error (m)
 */
public record HorizonGain(double ahead, Gain position) {}
