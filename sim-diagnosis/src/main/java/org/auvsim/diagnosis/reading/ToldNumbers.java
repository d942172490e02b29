package org.auvsim.diagnosis.reading;

import org.auvsim.diagnosis.run.Channel;
import org.auvsim.diagnosis.run.EulerAngles;
import org.auvsim.diagnosis.run.MeasuredRun;

import java.util.Arrays;

/** The numbers of a column: of orientations roll, pitch or yaw (rad). */
final class ToldNumbers {
    private ToldNumbers() {}

    /** Those along or about an axis (0 to 2), at all samples at which it was measured. */
    static double[] of(MeasuredRun run, Channel channel, int axis) {
        return Arrays.stream(run.samples(channel, axis))
                .mapToDouble(sample -> of(run, channel, axis, sample))
                .toArray();
    }

    private static double of(MeasuredRun run, Channel channel, int axis, int sample) {
        return channel == Channel.ORIENTATION
                ? EulerAngles.of(run.orientation(sample).orElseThrow()).component(axis)
                : run.value(channel, sample, axis);
    }
}
