package org.auvsim.experiments.hidden;

import java.util.function.DoubleFunction;

/**
 * One effect at any strength.
 *
 * @param unit a strength to begin with
 * @param least strength at which it is what it is, and not something else
 * @param most strength that makes sense
 * @param of the effect at a strength above 0
 */
record Family(double unit, double least, double most, DoubleFunction<HiddenEffect> of) {
    static Family of(double unit, DoubleFunction<HiddenEffect> of) {
        return new Family(unit, 0, Double.POSITIVE_INFINITY, of);
    }

    static Family between(double least, double most, DoubleFunction<HiddenEffect> of) {
        return new Family(least, least, most, of);
    }

    static Family upTo(double most, DoubleFunction<HiddenEffect> of) {
        return new Family(most / 4, 0, most, of);
    }
}
