package org.auvsim.diagnosis.reading;

import org.apache.commons.math3.stat.StatUtils;
import org.auvsim.diagnosis.run.Channel;
import org.auvsim.diagnosis.run.MeasuredRun;

import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;

/**
 * Numbers at the end of a sensor's range: while the body is beyond it they stay at the largest or
 * the smallest that there is, to the last digit, though all others have noise. That it is beyond is
 * all that they tell.
 */
final class Clipped {
    /** By chance noise repeats no number, and no extreme one so many times in a row. */
    private static final int IN_A_ROW = 4;

    /** A body comes to the end by so many usual changes at most. */
    private static final double NEAR = 10;

    private final Source source;
    private final MeasuredRun run;
    private final LeftOut beyond;

    private Clipped(Source source, MeasuredRun run) {
        this.source = source;
        this.run = run;
        this.beyond = new LeftOut(run);
    }

    /** Those of a run. */
    static LeftOut of(Source source, MeasuredRun run) {
        Clipped clipped = new Clipped(source, run);
        return clipped.beyond.lookingAt(
                List.of(Channel.POSITION, Channel.VELOCITY, Channel.ANGULAR_VELOCITY),
                clipped::find);
    }

    private void find(Channel channel, int axis) {
        int[] samples = run.samples(channel, axis);
        double[] values = ToldNumbers.of(run, channel, axis);
        if (values.length < UsualChange.FEWEST) {
            return;
        }
        double[] ends = {StatUtils.max(values), StatUtils.min(values)};
        boolean[] stays = atEnds(values, ends);
        double usual = UsualChange.of(values, stays);
        if (Double.isNaN(usual) || !isReached(values, stays, NEAR * usual)) {
            return;
        }
        for (double end : ends) {
            int[] at =
                    IntStream.range(0, values.length)
                            .filter(i -> stays[i] && values[i] == end)
                            .toArray();
            if (at.length > 0) {
                Arrays.stream(at).forEach(i -> beyond.add(channel, samples[i], axis));
                tell(channel, axis, end, at.length);
            }
        }
    }

    /** Which of them are at an end where several in a row are. */
    private static boolean[] atEnds(double[] values, double[] ends) {
        boolean[] at = new boolean[values.length];
        for (double end : ends) {
            if (longest(values, end) >= IN_A_ROW) {
                for (int i = 0; i < values.length; i++) {
                    at[i] |= values[i] == end;
                }
            }
        }
        return at;
    }

    /** How many in a row at most are some number. */
    private static int longest(double[] values, double number) {
        int longest = 0;
        int now = 0;
        for (double value : values) {
            now = value == number ? now + 1 : 0;
            longest = Math.max(longest, now);
        }
        return longest;
    }

    /** Whether what is beside those that stay is near them: the body went there, and came back. */
    private static boolean isReached(double[] values, boolean[] stays, double near) {
        return IntStream.range(1, values.length)
                .filter(i -> stays[i] != stays[i - 1])
                .allMatch(i -> Math.abs(values[i] - values[i - 1]) <= near);
    }

    private void tell(Channel channel, int axis, double end, int count) {
        beyond.tell(
                source.says(
                        List.of(source.column(run, channel, axis)),
                        "%d readings are %s exactly, several in a row, where its sensor seems to end; treated as not measured; if that is right, leave such cells empty"
                                .formatted(count, Figures.shown(end))));
    }
}
