package org.auvsim.auvsml.message.feedback;

import org.auvsim.core.math.Numbers;

/** One row of a {@link Covariance}. */
public record CovarianceRow(Numbers values) {}
