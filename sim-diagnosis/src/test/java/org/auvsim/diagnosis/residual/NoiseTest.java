package org.auvsim.diagnosis.residual;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.diagnosis.run.Channel;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.run.MeasuredRunBuilder;
import org.junit.jupiter.api.Test;

import java.util.List;
import java.util.Random;

/** Noise by the measurement alone, of a path and turns that are known. */
class NoiseTest {
    private static final int SAMPLES = 600;

    /**
     * Round a circle of 20 m, with noise of these sizes along x, y and z (m) and of a yaw (rad).
     */
    private static MeasuredRun run(double x, double y, double z, double yaw) {
        Random random = new Random(11);
        MeasuredRunBuilder run = MeasuredRun.named("run");
        for (int k = 0; k < SAMPLES; k++) {
            double a = 0.01 * k;
            run.at(0.1 * k)
                    .position(
                            20 * Math.cos(a) + x * random.nextGaussian(),
                            20 * Math.sin(a) + y * random.nextGaussian(),
                            -5 + z * random.nextGaussian())
                    .orientation(
                            Quat.ofAxisAngle(new Vec3(0, 0, 1), a + yaw * random.nextGaussian()));
        }
        return run.build();
    }

    /** A depth sensor beside a poor fix is as good as it is. */
    @Test
    void axesThatDifferHaveTheirOwn() {
        Noise noise = Noise.of(List.of(run(0.8, 0.9, 0.01, 0.02)));

        assertThat(noise.of(Channel.POSITION, 0)).isCloseTo(0.85, within(0.1));
        assertThat(noise.of(Channel.POSITION, 1))
                .isCloseTo(noise.of(Channel.POSITION, 0), within(0.15));
        assertThat(noise.of(Channel.POSITION, 2)).isCloseTo(0.01, within(0.001));
        assertThat(noise.of(Channel.POSITION)).isCloseTo(0.7, within(0.1));
    }

    /** Of hundreds of rows a height three times as good is no chance. */
    @Test
    void axesThatDifferMoreThanByChanceHaveTheirOwn() {
        Noise noise = Noise.of(List.of(run(0.3, 0.3, 0.1, 0.02)));

        assertThat(noise.of(Channel.POSITION, 0)).isCloseTo(0.3, within(0.03));
        assertThat(noise.of(Channel.POSITION, 2)).isCloseTo(0.1, within(0.01));
    }

    /** A fix of the position in every tenth row, the depth in each. */
    @Test
    void numbersInSomeRowsTellAsMuch() {
        Random random = new Random(5);
        MeasuredRunBuilder run = MeasuredRun.named("run");
        for (int k = 0; k < 10 * SAMPLES; k++) {
            boolean isFixed = k % 10 == 5;
            double a = 0.001 * k;
            run.at(0.1 * k)
                    .position(
                            isFixed ? 20 * Math.cos(a) + 0.5 * random.nextGaussian() : Double.NaN,
                            isFixed ? 20 * Math.sin(a) + 0.5 * random.nextGaussian() : Double.NaN,
                            -5 + 0.01 * random.nextGaussian());
        }

        Noise noise = Noise.of(List.of(run.build()));

        assertThat(noise.of(Channel.POSITION, 0)).isCloseTo(0.5, within(0.05));
        assertThat(noise.of(Channel.POSITION, 1)).isCloseTo(0.5, within(0.05));
        assertThat(noise.of(Channel.POSITION, 2)).isCloseTo(0.01, within(0.001));
    }

    /** Which may be far between one and the next while the body goes fast. */
    @Test
    void unevenTimesLookLikeNoNoise() {
        Random random = new Random(6);
        MeasuredRunBuilder run = MeasuredRun.named("run");
        for (int k = 0; k < SAMPLES; k++) {
            double t = 0.1 * k + (k % 2 == 0 ? 0 : 0.05);
            run.at(t)
                    .position(
                            2 * t + 0.01 * random.nextGaussian(),
                            0.1 * t * t + 0.01 * random.nextGaussian(),
                            Double.NaN)
                    .orientation(
                            Quat.ofAxisAngle(
                                    new Vec3(0, 0, 1), 0.5 * t + 0.01 * random.nextGaussian()));
        }

        Noise noise = Noise.of(List.of(run.build()));

        assertThat(noise.of(Channel.POSITION)).isCloseTo(0.01, within(0.001));
        assertThat(noise.of(Channel.ORIENTATION)).isCloseTo(0.01, within(0.001));
    }

    @Test
    void axesThatHardlyDifferShareTheirs() {
        Noise noise = Noise.of(List.of(run(0.1, 0.1, 0.1, 0.02)));

        assertThat(noise.of(Channel.POSITION, 0)).isCloseTo(0.1, within(0.005));
        assertThat(noise.of(Channel.POSITION, 2)).isEqualTo(noise.of(Channel.POSITION, 0));
    }

    /** A pendulum turns about one axis, a ship stays at its height. */
    @Test
    void whatNeverChangesTellsNothing() {
        MeasuredRun run = run(0.1, 0.1, 0, 0.02);
        Noise noise = Noise.of(List.of(run));

        assertThat(noise.tells(Channel.POSITION, 1)).isTrue();
        assertThat(noise.tells(Channel.POSITION, 2)).isFalse();
        assertThat(noise.of(Channel.POSITION)).isCloseTo(0.1, within(0.01));
        assertThat(noise.tells(Channel.ORIENTATION, 0)).isFalse();
        assertThat(noise.of(Channel.ORIENTATION)).isCloseTo(0.02, within(0.002));
        assertThat(new Misses(run, noise).rows())
                .containsExactly(
                        new Misses.Row(Channel.POSITION, 0),
                        new Misses.Row(Channel.POSITION, 1),
                        new Misses.Row(Channel.ORIENTATION, 2));
    }

    /** In one run a vehicle keeps its depth, to what its sensor counts; in another it dives. */
    @Test
    void whatChangesInAnotherRunTellsSomething() {
        Noise noise = Noise.of(List.of(run(0.1, 0.1, 0, 0.02), run(0.1, 0.1, 0.1, 0.02)));

        assertThat(noise.tells(Channel.POSITION, 2)).isTrue();
    }

    /** A sensor that is dead in two runs of three does not make the third one's noise small. */
    @Test
    void aRunInWhichItNeverChangesTellsNothingOfNoise() {
        MeasuredRun dead = run(0.1, 0.1, 0, 0.02);
        Noise noise = Noise.of(List.of(dead, run(0.1, 0.1, 0.1, 0.02), dead));

        assertThat(noise.of(Channel.POSITION, 2)).isCloseTo(0.1, within(0.01));
        assertThat(Noise.changes(dead, Channel.POSITION, 2)).isFalse();
        assertThat(Noise.changes(dead, Channel.POSITION, 0)).isTrue();
    }
}
