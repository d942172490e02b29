package org.auvsim.diagnosis.fit;

import org.auvsim.diagnosis.model.BelievedModel;
import org.auvsim.diagnosis.model.Variant;

/**
 * The model in steps of two lengths.
 *
 * @param model in steps that are short enough for predictions
 * @param rough the same in longer ones, where that does for differences of two of its motions; else
 *     in the same ones
 */
record Stepping(BelievedModel model, BelievedModel rough) {
    /** Longer steps are longer by this factor. */
    private static final double LONGER = 4;

    /** Differences in the steps of predictions, too. */
    static Stepping exact(BelievedModel model) {
        return new Stepping(model, model);
    }

    /** Differences in longer steps, which may turn out to be too long. */
    static Stepping hopeful(BelievedModel model) {
        return new Stepping(model, model.stepping(LONGER * model.scenario().timeStep().delta()));
    }

    /** The body as it is believed. */
    Variant variant() {
        return model.variant();
    }
}
