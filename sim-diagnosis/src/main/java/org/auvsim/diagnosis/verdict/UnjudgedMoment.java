package org.auvsim.diagnosis.verdict;

import org.auvsim.diagnosis.cause.Quantity;
import org.auvsim.diagnosis.result.Finding;
import org.auvsim.diagnosis.result.Moments;
import org.auvsim.diagnosis.run.MeasuredRun;

import java.util.List;
import java.util.Optional;

/** Whether what was found acts at a time of the world at which there is no held-out run. */
final class UnjudgedMoment {
    private static final String ONCE = "at";

    private UnjudgedMoment() {}

    /** What is to be said of it; empty where a held-out run is of that time, or for any other. */
    static Optional<String> notice(List<Finding> selected, List<MeasuredRun> heldOut) {
        boolean isUnjudged =
                selected.stream()
                        .allMatch(cause -> heldOut.stream().noneMatch(run -> mayActIn(run, cause)));
        return isUnjudged
                ? Optional.of(
                        "what was found acts at a time at which there is no held-out run, by the"
                                + " clock of the runs: none of them can bear it out or deny it")
                : Optional.empty();
    }

    private static boolean mayActIn(MeasuredRun run, Finding cause) {
        return cause.quantities().stream()
                .filter(Moments::isMoment)
                .findFirst()
                .map(moment -> isOfItsTime(run, moment))
                .orElse(true);
    }

    /** An impulse acts once, what begins goes on. */
    private static boolean isOfItsTime(MeasuredRun run, Quantity moment) {
        double end = run.time(0) + run.duration();
        boolean isOver = moment.name().equals(ONCE) && moment.value() < run.time(0);
        return moment.value() < end && !isOver;
    }
}
