package org.auvsim.experiments.hidden;

/**
 * Two causes that look alike.
 *
 * @param areAlike whether these runs cannot tell them apart, or can
 */
public record Twins(String first, String second, boolean areAlike) {}
