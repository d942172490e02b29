package org.auvsim.viz.scene;

/**
 * Something worth telling.
 *
 * @param time of the world (s)
 * @param text a sentence for people
 */
public record Occurrence(double time, String text) {}
