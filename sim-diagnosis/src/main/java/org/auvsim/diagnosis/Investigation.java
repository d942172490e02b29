package org.auvsim.diagnosis;

import org.auvsim.diagnosis.cause.Cause;
import org.auvsim.diagnosis.fit.Examination;
import org.auvsim.diagnosis.fit.Progress;
import org.auvsim.diagnosis.model.BelievedModel;
import org.auvsim.diagnosis.result.Diagnosis;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.run.Split;

import java.util.List;

/**
 * Finds what a model gets wrong of measured runs. Immutable; each method but {@link #diagnose}
 * returns one that differs in one thing.
 *
 * @param fit runs that the causes are searched with
 * @param heldOut runs that only judge; empty: the fit runs, or parts of the only one, are split
 * @param causes candidates
 * @param seed of what is drawn by lot
 * @param progress is told how far it is
 */
public record Investigation(
        BelievedModel model,
        List<MeasuredRun> fit,
        List<MeasuredRun> heldOut,
        List<Cause> causes,
        long seed,
        Progress progress) {
    /** The lists cannot be changed. */
    public Investigation {
        fit = List.copyOf(fit);
        heldOut = List.copyOf(heldOut);
        causes = List.copyOf(causes);
    }

    /**
     * What the runs say of the model.
     *
     * @throws IllegalArgumentException if nothing is held out and there is only one run, which is
     *     too short to be split
     */
    public Diagnosis diagnose() {
        if (heldOut.isEmpty()) {
            Split split = Split.of(fit);
            return new Investigation(model, split.fit(), split.heldOut(), causes, seed, progress)
                    .diagnose()
                    .noticing(List.of(split.notice()));
        }
        return new Examination(model, fit, heldOut, causes, seed, progress).diagnosis();
    }
}
