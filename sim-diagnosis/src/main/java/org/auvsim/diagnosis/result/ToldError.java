package org.auvsim.diagnosis.result;

import org.auvsim.diagnosis.run.Channel;

import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * The error of predictions that a sentence tells.
 *
 * @param isLeftOut whether it is that of leaving each run out in turn, not of held-out runs
 */
record ToldError(Channel channel, Gain gain, boolean isLeftOut) {
    /** An error that is so many times another one is worse, and not by chance. */
    private static final double WORSE = 1.1;

    /** That of the position, or else the first, unless another one alone gains. */
    static Optional<ToldError> of(Map<Channel, Gain> gains, boolean areLeftOut) {
        List<ToldError> all =
                gains.entrySet().stream()
                        .map(of -> new ToldError(of.getKey(), of.getValue(), areLeftOut))
                        .sorted(Comparator.comparing(ToldError::channel))
                        .toList();
        return all.stream()
                .filter(ToldError::isBetter)
                .findFirst()
                .or(() -> all.stream().findFirst());
    }

    private boolean isBetter() {
        return WORSE * gain.after() < gain.before();
    }

    /** Whether what was found makes it larger. */
    boolean isWorse() {
        return gain.after() > WORSE * gain.before();
    }

    /** Of the model as it is believed. */
    String before() {
        return words(text(gain.before()));
    }

    /** Of that, and of what was found. */
    String change() {
        return words(text(gain.before()) + " -> " + text(gain.after()));
    }

    private String words(String error) {
        return "%s %s error %s, noise is %s"
                .formatted(
                        isLeftOut ? "left-out" : "held-out",
                        channel.words(),
                        error,
                        text(gain.noise()));
    }

    private String text(double value) {
        return Numbers.rounded(value) + " " + channel.unit();
    }
}
