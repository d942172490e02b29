package org.auvsim.diagnosis.shooting;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.auvsim.core.entity.Frame;
import org.auvsim.core.entity.NamedForce;
import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.diagnosis.model.Ensemble;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.run.MeasuredRunBuilder;
import org.auvsim.diagnosis.run.ScheduledForce;
import org.auvsim.server.feedback.RigidMotion;
import org.junit.jupiter.api.Test;

import java.util.Arrays;
import java.util.List;

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

    /** A command changes at sample 4, and a force ends between samples 9 and 10. */
    @Test
    void predictionsHaveKnotsWhereSomethingChanges() {
        MeasuredRunBuilder told = MeasuredRun.named("told").commands(List.of("motor"));
        for (int k = 0; k < SAMPLES; k++) {
            told.at(k * APART).position(0, 0, 0).command(0, k < 4 ? 0.2 : 0.7);
        }
        NamedForce tow = NamedForce.direct("tow", Frame.WORLD, new Vec3(1, 0, 0));
        told.force(new ScheduledForce(0, 9.5 * APART, tow));

        assertThat(Knots.atEachCommand(told.build(), window, 0.15).samples())
                .containsExactly(0, 1, 4, 7, 9, 10, 13, 16, 19, 20);
    }

    @Test
    void betweenKnotsAMotionIsFilledIn() {
        Knots knots = Knots.of(run, window, 0.1);

        RigidMotion[] filled = knots.filled(knots.of(motion));

        for (int k = 0; k < SAMPLES; k++) {
            for (double off : filled[k].minus(motion[k])) {
                assertThat(off).isCloseTo(0, within(1e-12));
            }
        }
    }

    @Test
    void whatGotLostStaysLost() {
        Knots knots = Knots.of(run, window, 0.1);
        RigidMotion[] lost = new RigidMotion[knots.samples().length];
        Arrays.fill(lost, Ensemble.LOST);

        assertThat(knots.filled(lost)).hasSize(SAMPLES).containsOnly(Ensemble.LOST);
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
