package org.auvsim.diagnosis.residual;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.auvsim.core.entity.Frame;
import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.diagnosis.model.Sensing;
import org.auvsim.diagnosis.run.Channel;
import org.auvsim.diagnosis.run.EulerAngles;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.run.MeasuredRunBuilder;
import org.auvsim.server.feedback.RigidMotion;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import java.util.List;
import java.util.Random;

/** A vehicle of which pitch and heading are measured, but not roll, wherever it heads for. */
class OneAngleTest {
    private static final double NOISE = 0.01;
    private static final double OFF = 0.1;

    /** Of the world's axes, pitch turns about the one across the heading. */
    @ParameterizedTest(name = "heading {0}")
    @CsvSource({"0.0, 1", "0.6, 1", "1.5, 0", "3.0, 1", "-1.7, 0"})
    void itsPitchIsMissedAndNotItsRoll(double heading, int across) {
        MeasuredRun run = measured(heading);
        Misses misses = new Misses(run, Noise.of(List.of(run)));
        Quat told = run.orientation(0).orElseThrow();
        double noise = misses.deviation(0);

        assertThat(misses.rows())
                .containsExactly(
                        new Misses.Row(Channel.ORIENTATION, 1),
                        new Misses.Row(Channel.ORIENTATION, 2));
        assertThat(missed(misses, told.times(Quat.ofAxisAngle(new Vec3(0, 1, 0), OFF)))[0])
                .isCloseTo(OFF / noise, within(1e-9));
        assertThat(missed(misses, told.times(Quat.ofAxisAngle(new Vec3(1, 0, 0), OFF)))[0])
                .isCloseTo(0, within(1e-9));
        assertThat(misses.turns(0)[across]).isTrue();
        assertThat(misses.turns(0)[1 - across]).isFalse();
        assertThat(noise).isBetween(0.5 * NOISE, 2 * NOISE);
    }

    /** Rolled by 0.5 rad and pitched by -0.7 it heads where it headed. */
    @Test
    void aHeadingAloneIsTheSameHeadingOfABodyThatRollsAndPitches() {
        MeasuredRunBuilder measured = MeasuredRun.named("turn");
        for (int k = 0; k < 60; k++) {
            Quat q = EulerAngles.orientation(0, 0, 3.1 + NOISE * Math.sin(k));
            measured.at(0.1 * k).orientation(q, false, false, true);
        }
        MeasuredRun run = measured.build();
        Misses misses = new Misses(run, Noise.of(List.of(run)));
        double noise = misses.deviation(0);

        assertThat(missed(misses, EulerAngles.orientation(0.5, -0.7, 3.1))[0])
                .isCloseTo(0, within(1e-9));
        assertThat(missed(misses, EulerAngles.orientation(0.5, -0.7, -3.1))[0])
                .isCloseTo((2 * Math.PI - 6.2) / noise, within(1e-9));
    }

    /** A pendulum's angle goes all around. */
    @ParameterizedTest(name = "{0} for {1}")
    @CsvSource({"2.4, 2.5, -0.1", "1.6, 1.5, 0.1", "-1.6, -1.5, -0.1", "3.1, -3.1, -0.08319"})
    void aPitchAloneMayPassTheTop(double told, double measured, double off) {
        MeasuredRunBuilder swing =
                MeasuredRun.named("swing").frame(Channel.ORIENTATION, Frame.BODY);
        for (int k = 0; k < 60; k++) {
            Quat q = EulerAngles.orientation(0, measured + NOISE * Math.sin(k), 0);
            swing.at(0.1 * k).orientation(q, false, true, false);
        }
        MeasuredRun run = swing.build();
        Misses misses = new Misses(run, Noise.of(List.of(run)));

        assertThat(missed(misses, EulerAngles.orientation(0, told, 0))[0] * misses.deviation(0))
                .isCloseTo(off, within(1e-5));
    }

    private static double[] missed(Misses misses, Quat orientation) {
        RigidMotion motion = new RigidMotion(Vec3.ZERO, orientation, Vec3.ZERO, Vec3.ZERO);
        return misses.of(new RigidMotion[] {motion}, Sensing.EXACT, 0, 1);
    }

    private static MeasuredRun measured(double heading) {
        Random random = new Random(4);
        MeasuredRunBuilder run = MeasuredRun.named("dive").frame(Channel.ORIENTATION, Frame.BODY);
        for (int k = 0; k < 60; k++) {
            double pitch = 0.2 * Math.sin(0.1 * k) + NOISE * random.nextGaussian();
            double yaw = heading + NOISE * random.nextGaussian();
            run.at(0.1 * k).orientation(EulerAngles.orientation(0, pitch, yaw), false, true, true);
        }
        return run.build();
    }
}
