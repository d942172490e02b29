package org.auvsim.diagnosis.fit;

import org.auvsim.core.entity.Effect;
import org.auvsim.diagnosis.model.BelievedModel;
import org.auvsim.diagnosis.model.Ensemble.Commands;
import org.auvsim.diagnosis.model.Variant;

import java.util.List;

/**
 * The model in steps of two lengths.
 *
 * @param model in steps that are short enough for predictions
 * @param rough the same in longer ones, where that does for differences of two of its motions; else
 *     in the same ones
 * @param commands how they hold in those of differences
 */
record Stepping(BelievedModel model, BelievedModel rough, Commands commands) {
    /** Longer steps are longer by these factors. */
    private static final List<Double> LONGER = List.of(4.0, 2.0);

    /** Differences in the steps of predictions, too. */
    static Stepping exact(BelievedModel model) {
        return new Stepping(model, model, Commands.FROM_ROW_TO_ROW);
    }

    /** Differences in half of a step (s). */
    static Stepping finer(BelievedModel model, double step) {
        return new Stepping(model, model.stepping(step / 2), Commands.FROM_ROW_TO_ROW);
    }

    /** Differences in longer steps, which may turn out to be too long; the longest first. */
    static List<Stepping> longer(BelievedModel model) {
        double step = model.scenario().timeStep().delta();
        return LONGER.stream()
                .map(by -> new Stepping(model, model.stepping(by * step), Commands.EVENED))
                .toList();
    }

    /** The same for a variant: longer steps would miss what acts on it for a few of the others. */
    Stepping of(Variant variant) {
        return variant.body().effect().stream().anyMatch(Effect::isAbrupt) ? exact(model) : this;
    }

    /** The body as it is believed. */
    Variant variant() {
        return model.variant();
    }
}
