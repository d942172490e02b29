package org.auvsim.diagnosis;

import org.auvsim.diagnosis.cause.Cause;
import org.auvsim.diagnosis.field.FieldSearch;
import org.auvsim.diagnosis.fit.Course;
import org.auvsim.diagnosis.fit.Progress;
import org.auvsim.diagnosis.genetic.Evolution;
import org.auvsim.diagnosis.genetic.FormulaSearch;
import org.auvsim.diagnosis.model.BelievedModel;
import org.auvsim.diagnosis.result.Diagnosis;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.run.Split;
import org.auvsim.diagnosis.search.SteadyParts;
import org.auvsim.diagnosis.search.Way;
import org.auvsim.diagnosis.shaking.Imbalance;
import org.auvsim.diagnosis.shaking.SoundRuns;
import org.auvsim.diagnosis.verdict.Examination;

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
 * @param isThorough whether more causes than two at once are looked for where no fewer explain the
 *     runs
 * @param sound runs that are known to be sound: what is normal of the body's shaking
 * @param progress is told how far it is
 */
public record Investigation(
        BelievedModel model,
        List<MeasuredRun> fit,
        List<MeasuredRun> heldOut,
        List<Cause> causes,
        long seed,
        Method method,
        boolean isThorough,
        Optional<SoundRuns> sound,
        Progress progress) {
    private static final String NO_REFERENCE =
            "how the body shakes was measured, but is not compared: no reference runs were given";
    private static final String NOT_COMPARED =
            "how the body shakes cannot be compared with the reference runs: too few rows of steady"
                    + " thrust tell of it, or they are at other intervals";

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
        this(model, fit, heldOut, causes, seed, Method.SHOOTING, true, Optional.empty(), progress);
    }

    /** The same by another method. */
    public Investigation by(Method other) {
        return new Investigation(
                model, fit, heldOut, causes, seed, other, isThorough, sound, progress);
    }

    /** The same with runs that say what is normal of the body's shaking. */
    public Investigation comparedWith(SoundRuns reference) {
        return new Investigation(
                model,
                fit,
                heldOut,
                causes,
                seed,
                method,
                isThorough,
                Optional.of(reference),
                progress);
    }

    /**
     * The same of data that may not be what they are taken for: more than two causes at once would
     * imitate that.
     */
    public Investigation cursory() {
        return new Investigation(model, fit, heldOut, causes, seed, method, false, sound, progress);
    }

    /**
     * What the runs say of the model.
     *
     * @throws IllegalArgumentException if nothing is held out and there is only one run, which is
     *     too short to be split, or if something that moves is tied to the body
     */
    public Diagnosis diagnose() {
        model.tie()
                .ifPresent(
                        why -> {
                            throw new IllegalArgumentException(why);
                        });
        if (heldOut.isEmpty()) {
            Split split = Split.of(fit);
            return new Investigation(
                            model,
                            split.fit(),
                            split.heldOut(),
                            causes,
                            seed,
                            method,
                            isThorough,
                            sound,
                            progress)
                    .diagnose()
                    .noticing(List.of(split.notice()));
        }
        Way thorough = method == Method.GENETIC ? Way.by(new Evolution(seed)) : Way.THOROUGH;
        Course course = new Course(progress);
        course.at("following the runs", 0.01);
        SteadyParts toFit = SteadyParts.of(model, fit, course);
        SteadyParts toJudge = SteadyParts.of(model, heldOut, course);
        Diagnosis diagnosis =
                new Examination(
                                model,
                                toFit.runs(),
                                toJudge.runs(),
                                causes,
                                seed,
                                isThorough ? thorough : thorough.cursory(),
                                course::at)
                        .diagnosis(List.of(new FormulaSearch(seed), new FieldSearch()))
                        .noticing(toJudge.notices())
                        .noticing(toFit.notices());
        return shaken(diagnosis).toldAsFarAsItCame();
    }

    /** With what the body's shaking says, all of each run long. */
    private Diagnosis shaken(Diagnosis diagnosis) {
        List<MeasuredRun> whole =
                Stream.concat(fit.stream(), heldOut.stream())
                        .map(MeasuredRun::whole)
                        .distinct()
                        .toList();
        if (sound.isEmpty()) {
            return whole.stream().anyMatch(MeasuredRun::tellsShaking)
                    ? diagnosis.noticing(List.of(NO_REFERENCE))
                    : diagnosis;
        }
        return sound.get()
                .compared(whole)
                .map(shaking -> Imbalance.judged(diagnosis, shaking))
                .orElseGet(() -> diagnosis.noticing(List.of(NOT_COMPARED)));
    }
}
