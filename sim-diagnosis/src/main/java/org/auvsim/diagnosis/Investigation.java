package org.auvsim.diagnosis;

import org.auvsim.diagnosis.cause.Cause;
import org.auvsim.diagnosis.field.FieldSearch;
import org.auvsim.diagnosis.fit.Arena;
import org.auvsim.diagnosis.fit.Examination;
import org.auvsim.diagnosis.fit.Progress;
import org.auvsim.diagnosis.genetic.Evolution;
import org.auvsim.diagnosis.genetic.FormulaSearch;
import org.auvsim.diagnosis.model.BelievedModel;
import org.auvsim.diagnosis.result.Diagnosis;
import org.auvsim.diagnosis.result.Verdict;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.run.Split;

import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;

/**
 * Finds what a model gets wrong of measured runs. Immutable; each method but {@link #diagnose}
 * returns one that differs in one thing.
 *
 * @param fit runs that the causes are searched with
 * @param heldOut runs that only judge; empty: the fit runs, or parts of the only one, are split
 * @param causes candidates
 * @param seed of what is drawn by lot
 * @param method how causes are searched for
 * @param progress is told how far it is
 */
public record Investigation(
        BelievedModel model,
        List<MeasuredRun> fit,
        List<MeasuredRun> heldOut,
        List<Cause> causes,
        long seed,
        Method method,
        Progress progress) {
    /** The lists cannot be changed. */
    public Investigation {
        fit = List.copyOf(fit);
        heldOut = List.copyOf(heldOut);
        causes = List.copyOf(causes);
    }

    /** By multiple shooting. */
    public Investigation(
            BelievedModel model,
            List<MeasuredRun> fit,
            List<MeasuredRun> heldOut,
            List<Cause> causes,
            long seed,
            Progress progress) {
        this(model, fit, heldOut, causes, seed, Method.SHOOTING, progress);
    }

    /** The same by another method. */
    public Investigation by(Method other) {
        return new Investigation(model, fit, heldOut, causes, seed, other, progress);
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
            return new Investigation(
                            model, split.fit(), split.heldOut(), causes, seed, method, progress)
                    .diagnose()
                    .noticing(List.of(split.notice()));
        }
        Optional<Arena.Contest> contest =
                method == Method.GENETIC ? Optional.of(new Evolution(seed)) : Optional.empty();
        Diagnosis diagnosis =
                new Examination(model, fit, heldOut, causes, seed, contest, progress).diagnosis();
        return proposing(diagnosis).toldAsFarAsItCame();
    }

    /** With what imitates the misfit, where nothing that is known fits and the search ended. */
    private Diagnosis proposing(Diagnosis diagnosis) {
        if (diagnosis.verdict() != Verdict.UNEXPLAINED
                || diagnosis.proposal().isPresent()
                || !diagnosis.isComplete()
                || !progress.at("looking for a formula or a field", 0.95)) {
            return diagnosis;
        }
        return Stream.of(
                        new FormulaSearch(model, seed).proposal(diagnosis),
                        new FieldSearch(model).proposal(diagnosis))
                .flatMap(Optional::stream)
                .min(Comparator.comparingDouble(proposal -> proposal.heldOut().after()))
                .map(diagnosis::proposing)
                .orElse(diagnosis);
    }
}
