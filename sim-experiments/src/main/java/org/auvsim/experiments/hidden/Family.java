package org.auvsim.experiments.hidden;

import java.util.function.DoubleFunction;

/**
 * One effect at any strength.
 *
 * @param unit a strength to begin with
 * @param most strength that makes sense
 * @param of the effect at a strength above 0
 */
record Family(double unit, double most, DoubleFunction<HiddenEffect> of) {
    static Family of(double unit, DoubleFunction<HiddenEffect> of) {
        return new Family(unit, Double.POSITIVE_INFINITY, of);
    }

    static Family upTo(double most, DoubleFunction<HiddenEffect> of) {
        return new Family(most / 4, most, of);
    }
}
