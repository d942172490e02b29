package org.auvsim.diagnosis.verdict;

import org.auvsim.diagnosis.fit.Descent;
import org.auvsim.diagnosis.fit.Fit;
import org.auvsim.diagnosis.fit.Judged;
import org.auvsim.diagnosis.residual.Misses;
import org.auvsim.diagnosis.residual.Noise;
import org.auvsim.diagnosis.run.Channel;
import org.auvsim.diagnosis.run.MeasuredRun;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;

/**
 * What the model as it is believed misses of one channel alone, while it predicts all others to
 * their noise, once that one does not pull at the starts: often it is what measures it.
 */
final class MissedAlone {
    /** Enough for the starts. */
    private static final int STEPS = 8;

    private MissedAlone() {}

    /**
     * What is to be said of it; empty where others are missed, too, or nothing else is measured.
     */
    static Optional<String> notice(Judged none, Noise noise) {
        List<Channel> measured =
                Arrays.stream(Channel.values()).filter(of -> isMeasured(none, of)).toList();
        if (measured.size() < 2 || none.isWhite()) {
            return Optional.empty();
        }
        List<Channel> missed =
                measured.stream().filter(of -> without(of, none, noise).isWhite()).toList();
        return missed.size() != 1
                ? Optional.empty()
                : Optional.of(
                        "the model as it is predicts everything but the %s to the noise: either %s, or look at what measures it, which may be late, turned or off, or have errors that last (lasting-error of its columns, --mapping)"
                                .formatted(
                                        missed.getFirst().words(), otherwise(missed.getFirst())));
    }

    /** What might be wrong with the model instead. */
    private static String otherwise(Channel missed) {
        return switch (missed) {
            case POSITION, VELOCITY -> "a force acts that does not turn the body";
            case ORIENTATION, ANGULAR_VELOCITY -> "a torque acts that does not move the body";
        };
    }

    private static boolean isMeasured(Judged none, Channel channel) {
        return none.fit().data().stream().anyMatch(of -> of.count(channel) > 0);
    }

    /** The same model of the same runs, as if a channel had not been measured. */
    private static Judged without(Channel channel, Judged none, Noise noise) {
        Fit fit = none.fit();
        List<MeasuredRun> runs = fit.data().stream().map(of -> of.run().without(channel)).toList();
        return Descent.of(
                        new Fit(
                                fit.stepping(),
                                Misses.of(runs, noise),
                                fit.hypothesis(),
                                fit.windows(),
                                fit.knowledge()))
                .steps(STEPS);
    }
}
