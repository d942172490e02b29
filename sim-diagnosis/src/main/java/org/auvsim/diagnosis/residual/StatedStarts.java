package org.auvsim.diagnosis.residual;

import org.auvsim.core.math.Vec3;
import org.auvsim.diagnosis.result.Numbers;
import org.auvsim.diagnosis.run.Channel;
import org.auvsim.diagnosis.run.KnownStart;
import org.auvsim.diagnosis.run.MeasuredRun;

import java.util.Optional;
import java.util.stream.IntStream;

/** Whether runs begin, by what was measured, where they are stated to. */
public final class StatedStarts {
    /** Neither chance nor noise makes both differ by so many deviations. */
    private static final double MANY = 8;

    private StatedStarts() {}

    /** What is told of a run that does not. */
    public static Optional<String> notice(MeasuredRun run, Noise noise) {
        return run.start()
                .flatMap(
                        start ->
                                IntStream.range(0, 3)
                                        .filter(axis -> isOff(run, start, axis, noise))
                                        .mapToObj(axis -> told(run, start, axis))
                                        .findFirst());
    }

    private static boolean isOff(MeasuredRun run, KnownStart start, int axis, Noise noise) {
        double own = run.deviation(Channel.POSITION, 0, axis);
        double ofNoise = Double.isNaN(own) ? noise.of(Channel.POSITION, axis) : own;
        double deviation = StrictMath.hypot(start.deviations().get(axis), ofNoise);
        return Math.abs(measured(run, axis) - stated(start, axis)) > MANY * deviation;
    }

    private static double measured(MeasuredRun run, int axis) {
        return run.value(Channel.POSITION, 0, axis);
    }

    private static double stated(KnownStart start, int axis) {
        Vec3 position = start.motion().position();
        return position.component(axis);
    }

    private static String told(MeasuredRun run, KnownStart start, int axis) {
        return "%s: its first position %s is %s m, but its start is stated to be at %s +- %s m: one of them is wrong, or the measured positions are off"
                .formatted(
                        run.name(),
                        "xyz".charAt(axis),
                        Numbers.rounded(measured(run, axis)),
                        Numbers.rounded(stated(start, axis)),
                        Numbers.rounded(start.deviations().get(axis)));
    }
}
