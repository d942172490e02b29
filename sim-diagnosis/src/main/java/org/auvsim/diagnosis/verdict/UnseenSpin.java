package org.auvsim.diagnosis.verdict;

import org.auvsim.diagnosis.result.Finding;
import org.auvsim.diagnosis.run.Channel;
import org.auvsim.diagnosis.run.MeasuredRun;

import java.util.List;
import java.util.Optional;

/**
 * A Magnus force on a body of which neither an orientation nor a rate was measured, nor the spin
 * stated at a run's start: along a path only its coefficient times the spin shows.
 */
final class UnseenSpin {
    private UnseenSpin() {}

    /** What is to be said of such a force, if it was found. */
    static Optional<String> notice(List<MeasuredRun> runs, List<Finding> found) {
        return found.stream()
                .filter(of -> of.cause().equals("magnus"))
                .filter(_ -> runs.stream().allMatch(UnseenSpin::isIn))
                .findFirst()
                .map(UnseenSpin::words);
    }

    private static boolean isIn(MeasuredRun run) {
        return run.start().isEmpty()
                && !run.measures(Channel.ORIENTATION)
                && !run.measures(Channel.ANGULAR_VELOCITY);
    }

    private static String words(Finding magnus) {
        boolean isCoefficient = magnus.quantities().getFirst().unit().equals("kg");
        return "nothing tells how the body spins%s: measure its orientation, or state its spin at each run's start"
                .formatted(
                        isCoefficient
                                ? " but the scenario, and the coefficient of the Magnus force is as"
                                        + " doubtful as that"
                                : ", so what is told of the Magnus force is its coefficient times"
                                        + " the spin, of the same size in all runs");
    }
}
