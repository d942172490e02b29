package org.auvsim.diagnosis.residual;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.run.MeasuredRunBuilder;
import org.junit.jupiter.api.Test;

import java.util.List;
import java.util.Random;

/** How fast a body may begin, by what was measured of its motion at a steady speed. */
class LoosenessTest {
    private static final int VX = 6;
    private static final double SPEED = 1;

    /** Of what hardly exceeds the speed twice is allowed. */
    @Test
    void exactPlacesTellTheSpeed() {
        assertThat(speed(1e-6)).isCloseTo(2 * SPEED, within(0.05));
    }

    /** Over 0.4 s noise of 1 m alone would be some metres a second. */
    @Test
    void noiseIsNoSpeed() {
        assertThat(speed(1)).isBetween(SPEED, 4 * SPEED);
    }

    private static double speed(double deviation) {
        Random random = new Random(4);
        MeasuredRunBuilder steady = MeasuredRun.named("steady");
        for (int k = 0; k < 600; k++) {
            double t = 0.1 * k;
            steady.at(t)
                    .position(
                            SPEED * t + deviation * random.nextGaussian(),
                            deviation * random.nextGaussian(),
                            deviation * random.nextGaussian());
        }
        MeasuredRun run = steady.build();
        return Looseness.of(run, Noise.of(List.of(run))).get(VX);
    }
}
