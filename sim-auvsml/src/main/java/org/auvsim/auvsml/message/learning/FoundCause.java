package org.auvsim.auvsml.message.learning;

import java.util.List;

/**
 * Something that a model lacks, or has wrong.
 *
 * @param name its id, as {@code quadratic_drag}, and the part of the body that it is about
 * @param share of the misfit beyond noise that goes when this cause is added last, 0 to 1
 * @param quantity its numbers
 */
public record FoundCause(String name, double share, List<FoundQuantity> quantity) {}
