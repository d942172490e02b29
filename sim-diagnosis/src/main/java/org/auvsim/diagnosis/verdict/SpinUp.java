package org.auvsim.diagnosis.verdict;

import org.auvsim.core.actuator.Propulsor;
import org.auvsim.diagnosis.fit.Hypothesis;
import org.auvsim.diagnosis.model.BelievedModel;
import org.auvsim.diagnosis.run.MeasuredRun;

import java.util.List;
import java.util.Optional;

/**
 * Propulsors that follow their commands late and that a scenario has at another level than a run
 * begins with: they first have to spin up. If the log began when they were running, that is missed,
 * as if the body got a push at once.
 */
final class SpinUp {
    /** So many lags after a command hardly anything is left of the level before. */
    private static final double LAGS = 5;

    /** Levels that differ by less hardly push otherwise. */
    private static final double OTHER = 0.02;

    private SpinUp() {}

    /** What is to be said of an impulse that was found; empty where it comes later, or is none. */
    static Optional<String> notice(BelievedModel model, List<MeasuredRun> runs, Hypothesis found) {
        List<String> names =
                model.variant().body().component().stream()
                        .filter(Propulsor.class::isInstance)
                        .map(Propulsor.class::cast)
                        .filter(p -> runs.stream().anyMatch(r -> isWhileItSpinsUp(p, r, found)))
                        .map(Propulsor::name)
                        .toList();
        return names.isEmpty()
                ? Optional.empty()
                : Optional.of(
                        "the impulse is where '%s' %s what the first row commands: the scenario has %s at another level before; if the log begins when %s, state that in the scenario (level of the propulsor)"
                                .formatted(
                                        String.join("', '", names),
                                        names.size() == 1 ? "spins up to" : "spin up to",
                                        names.size() == 1 ? "it" : "them",
                                        names.size() == 1 ? "it is running" : "they are running"));
    }

    private static boolean isWhileItSpinsUp(Propulsor p, MeasuredRun run, Hypothesis found) {
        MeasuredRun whole = run.whole();
        double begin = whole.time(0);
        return whole.commands().stream()
                        .filter(command -> command.name().equals(p.name()))
                        .anyMatch(command -> Math.abs(command.level(0) - p.level()) > OTHER)
                && isImpulse(found, begin, begin + LAGS * p.lag());
    }

    /** Whether one was found between two times (s). */
    private static boolean isImpulse(Hypothesis found, double from, double until) {
        for (int c = 0; c < found.causes().size(); c++) {
            if (found.causes().get(c).id().equals("impulse")
                    && found.causes().get(c).quantities(found.theta().get(c)).stream()
                            .filter(q -> q.name().equals("at"))
                            .anyMatch(q -> from <= q.value() && q.value() < until)) {
                return true;
            }
        }
        return false;
    }
}
