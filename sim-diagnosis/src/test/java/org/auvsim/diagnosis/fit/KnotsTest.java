package org.auvsim.diagnosis.fit;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.diagnosis.model.Ensemble;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.run.MeasuredRunBuilder;
import org.auvsim.server.feedback.RigidMotion;
import org.junit.jupiter.api.Test;

import java.util.Arrays;

/** Between knots, what parts two motions is as smooth as they are. */
class KnotsTest {
    private static final int SAMPLES = 21;
    private static final double APART = 0.05;
    private static final double SPIN = 1.5;
    private static final double TILT = 1e-3;

    private final MeasuredRun run = run();
    private final Window window = new Window(0, SAMPLES - 1, spun(0, 0));
    private final RigidMotion[] motion = course(0);

    private static MeasuredRun run() {
        MeasuredRunBuilder run = MeasuredRun.named("run");
        for (int k = 0; k < SAMPLES; k++) {
            run.at(k * APART).position(0, 0, 0);
        }
        return run.build();
    }

    /** A body that spins about the vertical while it falls from rest, tilted by so much (rad). */
    private static RigidMotion spun(double time, double tilt) {
        Quat spin =
                new Quat(StrictMath.cos(SPIN * time / 2), 0, 0, StrictMath.sin(SPIN * time / 2));
        Quat lean = new Quat(StrictMath.cos(tilt / 2), StrictMath.sin(tilt / 2), 0, 0);
        return new RigidMotion(
                new Vec3(tilt * time * time / 2, 0, -5 * time * time),
                spin.times(lean),
                new Vec3(tilt * time, 0, -10 * time),
                new Vec3(0, 0, SPIN));
    }

    private static RigidMotion[] course(double tilt) {
        RigidMotion[] course = new RigidMotion[SAMPLES];
        Arrays.setAll(course, k -> spun(k * APART, tilt));
        return course;
    }

    @Test
    void knotsAreAStepApartAndEndWithTheWindow() {
        assertThat(Knots.of(run, window, 0.15).samples())
                .containsExactly(0, 3, 6, 9, 12, 15, 18, 20);
        assertThat(Knots.of(run, window, 0.01).samples()).hasSize(SAMPLES);
    }

    @Test
    void betweenKnotsATiltIsCarriedAlongBySpinAndAWayGrows() {
        Knots knots = Knots.of(run, window, 0.2);
        RigidMotion[] tilted = course(TILT);

        RigidMotion[] parted = knots.parted(motion, knots.of(motion), knots.of(tilted));

        for (int k = 0; k < SAMPLES; k++) {
            double[] off = parted[k].minus(tilted[k]);
            for (int i = 0; i < RigidMotion.SIZE; i++) {
                assertThat(off[i]).as("number %d of sample %d", i, k).isCloseTo(0, within(1e-7));
            }
        }
    }

    @Test
    void whatPartsFromALostMotionIsLost() {
        Knots knots = Knots.of(run, window, 0.2);
        RigidMotion[] lost = knots.of(motion);
        Arrays.fill(lost, Ensemble.LOST);

        assertThat(knots.parted(motion, knots.of(motion), lost)).containsOnly(Ensemble.LOST);
        assertThat(knots.parted(motion, lost, knots.of(motion))).containsOnly(Ensemble.LOST);
    }
}
