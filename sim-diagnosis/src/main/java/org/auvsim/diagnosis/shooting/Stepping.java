package org.auvsim.diagnosis.shooting;

import org.auvsim.core.entity.Effect;
import org.auvsim.diagnosis.model.BelievedModel;
import org.auvsim.diagnosis.model.Ensemble.Commands;
import org.auvsim.diagnosis.model.Variant;

import java.util.List;

/**
 * The model in steps of three lengths.
 *
 * @param fine in steps that are short enough, and end at each sample
 * @param model for predictions: in longer ones, which pass samples by, where that makes no
 *     difference that the data could show; else in the same ones
 * @param rough for differences of two of its motions: in longer ones still, where that does
 * @param commands how they hold in those of differences
 */
public record Stepping(
        BelievedModel fine, BelievedModel model, BelievedModel rough, Commands commands) {
    /** Longer steps are longer by these factors. */
    private static final List<Double> LONGER = List.of(4.0, 2.0);

    /** Those of predictions by these, but they are not longer than the longest (s). */
    private static final List<Double> LONGER_PREDICTIONS = List.of(5.0, 4.0, 3.0, 2.0);

    private static final double LONGEST = 0.1;

    /** All in the same steps. */
    public static Stepping exact(BelievedModel model) {
        return new Stepping(model, model, model, Commands.FROM_ROW_TO_ROW);
    }

    /** Differences in shorter steps (s). */
    public static Stepping finer(BelievedModel model, double step) {
        return new Stepping(model, model, model.stepping(step), Commands.FROM_ROW_TO_ROW);
    }

    /** Differences in longer steps, which may turn out to be too long; the longest first. */
    public static List<Stepping> longer(BelievedModel model) {
        return exact(model).withLongerDifferences();
    }

    /** Predictions in longer steps than one (s), alike. */
    public static List<Stepping> predictingLonger(BelievedModel model, double step) {
        return LONGER_PREDICTIONS.stream()
                .map(by -> by * step)
                .filter(length -> length < LONGEST * (1 + 1e-9))
                .map(model::stepping)
                .map(longer -> new Stepping(model, longer, longer, Commands.FROM_ROW_TO_ROW))
                .toList();
    }

    /** The same with differences in longer steps than those of predictions, alike. */
    public List<Stepping> withLongerDifferences() {
        double step = step(model);
        return LONGER.stream()
                .map(by -> new Stepping(fine, model, model.stepping(by * step), Commands.EVENED))
                .toList();
    }

    /** The same for a variant: longer steps would miss what acts on it for a few of the others. */
    public Stepping of(Variant variant) {
        boolean isAbrupt = variant.body().effect().stream().anyMatch(Effect::isAbrupt);
        boolean isLonger = step(rough) > step(fine);
        return isAbrupt && (isLonger || passesBy()) ? exact(fine) : this;
    }

    private static double step(BelievedModel model) {
        return model.scenario().timeStep().delta();
    }

    /** The same of a body that is idle but for what a run commands. */
    public Stepping idle() {
        return new Stepping(Idle.of(fine), Idle.of(model), Idle.of(rough), commands);
    }

    /** Whether predictions pass samples by. */
    public boolean passesBy() {
        return !model.equals(fine);
    }

    /** The body as it is believed. */
    public Variant variant() {
        return model.variant();
    }
}
