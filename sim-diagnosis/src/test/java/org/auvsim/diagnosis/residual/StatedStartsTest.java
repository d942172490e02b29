package org.auvsim.diagnosis.residual;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.diagnosis.run.KnownStart;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.run.MeasuredRunBuilder;
import org.auvsim.server.feedback.RigidMotion;
import org.junit.jupiter.api.Test;

import java.util.List;
import java.util.Random;
import java.util.stream.IntStream;

class StatedStartsTest {
    private static final double NOISE = 0.01;

    /** It begins at the origin, but for noise, and is stated to begin so far east (m). */
    private static MeasuredRun run(double east, double deviation) {
        Random random = new Random(2);
        RigidMotion start =
                new RigidMotion(new Vec3(east, 0, 0), Quat.IDENTITY, Vec3.ZERO, Vec3.ZERO);
        List<Double> deviations =
                IntStream.range(0, RigidMotion.SIZE).mapToObj(i -> deviation).toList();
        MeasuredRunBuilder run = MeasuredRun.named("dive").start(new KnownStart(start, deviations));
        for (int k = 0; k < 100; k++) {
            run.at(0.1 * k)
                    .position(
                            0.05 * k + NOISE * random.nextGaussian(),
                            NOISE * random.nextGaussian(),
                            Double.NaN);
        }
        return run.build();
    }

    private static Noise noise(MeasuredRun run) {
        return Noise.of(List.of(run));
    }

    @Test
    void aStartThatIsElsewhereIsTold() {
        MeasuredRun run = run(2, 0.02);

        assertThat(StatedStarts.notice(run, noise(run)).orElseThrow())
                .matches(
                        "dive: its first position x is -?0\\.0\\S* m, but its start is stated to be"
                                + " at 2\\.0 \\+- 0\\.020 m: one of them is wrong, or the measured"
                                + " positions are off");
    }

    @Test
    void oneThatMayBeOffSoFarIsNot() {
        assertThat(StatedStarts.notice(run(2, 1), noise(run(2, 1)))).isEmpty();
        assertThat(StatedStarts.notice(run(0.05, 0.0001), noise(run(0, 1)))).isEmpty();
    }
}
