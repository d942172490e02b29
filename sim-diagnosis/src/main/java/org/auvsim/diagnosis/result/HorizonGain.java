package org.auvsim.diagnosis.result;

/**
 * How well a held-out run is predicted some time ahead, from measured states all along it.
 *
 * @param ahead (s)
 * @param position error (m)
 */
public record HorizonGain(double ahead, Gain position) {}
