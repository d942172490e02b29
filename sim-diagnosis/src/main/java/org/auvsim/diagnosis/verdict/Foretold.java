package org.auvsim.diagnosis.verdict;

import org.auvsim.diagnosis.fit.Fit;
import org.auvsim.diagnosis.fit.Judged;
import org.auvsim.diagnosis.fit.LeaveOneOut;
import org.auvsim.diagnosis.residual.Noise;
import org.auvsim.diagnosis.residual.Outcome;
import org.auvsim.diagnosis.residual.Outcome.Squares;
import org.auvsim.diagnosis.result.Gain;
import org.auvsim.diagnosis.run.Channel;

import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;
import java.util.stream.Stream;

/**
 * How well runs are foretold that had no part in the fit.
 *
 * @param gains root mean square errors by channel, in its unit, without and with what was found,
 *     both from the starts that suit what was found, if that explains the runs
 * @param gain by how much twice the logarithm of their likelihood grows
 */
record Foretold(Map<Channel, Gain> gains, double gain) {
    /** It grows by more for a number two deviations off. */
    private static final double CHANCE = 4;

    /** Nearly all of what a true cause gains is foretold, of what fits one run by chance little. */
    private static final double SHARE = 0.4;

    /**
     * Held-out runs.
     *
     * @param before the model as it is believed, from the starts that suit it best
     * @param after what was found, likewise
     */
    static Foretold of(Judged before, Judged after, Noise noise) {
        return of(List.of(before), List.of(after), noise);
    }

    /**
     * The same, the errors from the starts that suit each: those that suit what explains nothing
     * would have the model as it is believed miss what it does not.
     */
    static Foretold ofUnexplained(Judged before, Judged after, Noise noise) {
        return of(
                List.of(before),
                List.of(after),
                gains(Stream.of(before.fit()), Stream.of(after.fit()), noise));
    }

    /** Each run by the others, where all were searched with. */
    static Foretold byTurns(LeaveOneOut before, LeaveOneOut after, Noise noise) {
        return of(before.predictions(), after.predictions(), noise);
    }

    /** Whether it is better than chance alone would have it. */
    boolean isBetter() {
        return gain > CHANCE;
    }

    /** Whether it gains much of what the causes gain where they are fitted to all these runs. */
    boolean isMuchOf(Judged none, Judged fitted) {
        return gain > SHARE * (deviance(runByRun(none)) - deviance(runByRun(fitted)));
    }

    private static List<Judged> runByRun(Judged of) {
        return IntStream.range(0, of.fit().data().size())
                .mapToObj(of.fit()::ofRun)
                .map(Judged::of)
                .toList();
    }

    private static Foretold of(List<Judged> before, List<Judged> after, Noise noise) {
        Stream<Fit> without = after.stream().map(j -> j.fit().asBelieved());
        return of(before, after, gains(without, after.stream().map(Judged::fit), noise));
    }

    private static Foretold of(List<Judged> before, List<Judged> after, Map<Channel, Gain> gains) {
        return new Foretold(gains, deviance(before) - deviance(after));
    }

    private static Map<Channel, Gain> gains(Stream<Fit> before, Stream<Fit> after, Noise noise) {
        Map<Channel, Squares> without = errors(before);
        Map<Channel, Squares> with = errors(after);
        Map<Channel, Gain> gains = new EnumMap<>(Channel.class);
        for (Channel channel : with.keySet()) {
            gains.put(
                    channel,
                    new Gain(
                            rootMeanSquare(without, channel),
                            rootMeanSquare(with, channel),
                            noise.of(channel)));
        }
        return gains;
    }

    /** Of all runs together. */
    private static Map<Channel, Squares> errors(Stream<Fit> runs) {
        Map<Channel, Squares> all = new EnumMap<>(Channel.class);
        runs.map(Fit::errors)
                .forEach(
                        run -> run.forEach((channel, of) -> all.merge(channel, of, Squares::plus)));
        return all;
    }

    private static double rootMeanSquare(Map<Channel, Squares> errors, Channel channel) {
        Squares of = errors.getOrDefault(channel, Outcome.NOTHING);
        return Math.sqrt(of.sum() / of.count());
    }

    private static double deviance(List<Judged> runs) {
        return runs.stream().mapToDouble(run -> run.outcome().deviance()).sum();
    }
}
