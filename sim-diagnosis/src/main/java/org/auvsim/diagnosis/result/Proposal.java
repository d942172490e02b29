package org.auvsim.diagnosis.result;

/**
 * A formula or field that imitates the misfit but is no known cause: something to think about.
 *
 * @param kind {@code formula} or {@code force_field}
 * @param text the formula, or what the field is made of
 * @param heldOut position error on held-out runs (m)
 */
public record Proposal(String kind, String text, Gain heldOut) {}
