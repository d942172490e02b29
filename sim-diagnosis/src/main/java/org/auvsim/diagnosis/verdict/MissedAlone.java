package org.auvsim.diagnosis.verdict;

import org.auvsim.diagnosis.fit.Judged;
import org.auvsim.diagnosis.residual.Misses;
import org.auvsim.diagnosis.residual.Whiteness;
import org.auvsim.diagnosis.run.Channel;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;

/**
 * What the model as it is believed misses of one channel alone, while it predicts all others to
 * their noise: most often it is what measures that channel.
 */
final class MissedAlone {
    private MissedAlone() {}

    /**
     * What is to be said of it; empty where others are missed, too, or nothing else is measured.
     */
    static Optional<String> notice(Judged none) {
        List<Channel> measured =
                Arrays.stream(Channel.values()).filter(of -> isMeasured(none, of)).toList();
        List<Channel> missed =
                measured.stream().filter(of -> whiteness(none, of) >= Whiteness.LIMIT).toList();
        return missed.size() != 1 || measured.size() < 2
                ? Optional.empty()
                : Optional.of(
                        "the model as it is predicts everything but the %s to the noise: look at what measures it, which may be late, turned or off, or have errors that last (lasting-error of its columns, --mapping)"
                                .formatted(missed.getFirst().words()));
    }

    private static boolean isMeasured(Judged none, Channel channel) {
        return none.fit().data().stream().anyMatch(of -> of.count(channel) > 0);
    }

    private static double whiteness(Judged none, Channel channel) {
        List<Misses> data = none.fit().data();
        return IntStream.range(0, data.size())
                .mapToDouble(
                        r ->
                                Whiteness.largest(
                                        none.outcome().misses().get(r), data.get(r), channel))
                .max()
                .orElse(0);
    }
}
