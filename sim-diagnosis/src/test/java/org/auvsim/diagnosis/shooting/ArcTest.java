package org.auvsim.diagnosis.shooting;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.server.feedback.RigidMotion;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * A top that circles and precesses: between two instants it is where it is, to the fourth order.
 */
class ArcTest {
    private static final double RADIUS = 2;
    private static final double CIRCLING = 1.5;
    private static final double PRECESSION = 1.1;
    private static final double SPIN = 2.3;
    private static final Vec3 UP = new Vec3(0, 0, 1);
    private static final Vec3 TILTED = new Vec3(0.6, 0, 0.8);

    private static RigidMotion at(double t) {
        double angle = CIRCLING * t;
        double speed = RADIUS * CIRCLING;
        Quat precessed = Quat.ofAxisAngle(UP, PRECESSION * t);
        Vec3 spin = precessed.rotate(TILTED).times(SPIN);
        return new RigidMotion(
                new Vec3(RADIUS * Math.cos(angle), RADIUS * Math.sin(angle), 0.3 * t),
                precessed.times(Quat.ofAxisAngle(TILTED, SPIN * t)),
                new Vec3(-speed * Math.sin(angle), speed * Math.cos(angle), 0.3),
                UP.times(PRECESSION).plus(spin));
    }

    /** Errors of ways and turns fall with the fourth power of the time, of their rates third. */
    @ParameterizedTest(name = "{0} s")
    @ValueSource(doubles = {0.02, 0.05, 0.1})
    void betweenItsEndsItRunsAsTheMotionDoes(double duration) {
        double from = 0.7;
        Arc arc = Arc.between(at(from), at(from + duration), duration);
        for (double share : new double[] {0, 0.2, 0.5, 0.9, 1}) {
            double[] off = arc.at(share).minus(at(from + share * duration));
            double fourth = Math.pow(duration, 4);
            double third = Math.pow(duration, 3);
            assertThat(norm(off, 0)).as("way at %s", share).isLessThan(0.1 * fourth + 1e-14);
            assertThat(norm(off, 3)).as("turn at %s", share).isLessThan(0.1 * fourth + 1e-14);
            assertThat(norm(off, 6)).as("velocity at %s", share).isLessThan(0.3 * third + 1e-13);
            assertThat(norm(off, 9)).as("spin at %s", share).isLessThan(0.5 * third + 1e-13);
        }
    }

    private static double norm(double[] numbers, int from) {
        return new Vec3(numbers[from], numbers[from + 1], numbers[from + 2]).norm();
    }
}
