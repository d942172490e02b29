package org.auvsim.server.feedback;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.util.Random;

class RigidMotionTest {
    private static final Vec3 AXIS = new Vec3(1, 2, 2).times(1.0 / 3);

    /** A body under constant acceleration that turns evenly about an axis, at a time. */
    private static RigidMotion accelerated(double t) {
        Vec3 acceleration = new Vec3(0.5, -1, 2);
        return new RigidMotion(
                new Vec3(3 * t, 1, 0).plus(acceleration.times(t * t / 2)),
                Quat.ofAxisAngle(AXIS, 0.8 * t),
                new Vec3(3, 0, 0).plus(acceleration.times(t)),
                AXIS.times(0.8));
    }

    @ParameterizedTest
    @ValueSource(doubles = {0, 0.3, 0.75, 1})
    void betweenTwoMotionsItIsExactForConstantAcceleration(double share) {
        RigidMotion between = RigidMotion.between(accelerated(1), accelerated(1.5), 0.5, share);
        double[] miss = between.minus(accelerated(1 + 0.5 * share));
        for (double part : miss) {
            assertThat(part).isCloseTo(0, within(1e-14));
        }
    }

    @ParameterizedTest(name = "seed {0}")
    @ValueSource(longs = {1, 2, 3})
    void anErrorThatIsAddedIsTheDifference(long seed) {
        Random random = new Random(seed);
        double[] error = random.doubles(12, -1.5, 1.5).toArray();
        double[] difference = accelerated(1).plus(error).minus(accelerated(1));
        for (int i = 0; i < 12; i++) {
            assertThat(difference[i]).isCloseTo(error[i], within(1e-14));
        }
    }

    @Test
    void theShorterWayIsTurned() {
        Quat to = Quat.ofAxisAngle(AXIS, 2 * Math.PI - 0.1);
        assertThat(Turns.between(Quat.IDENTITY, to).distance(AXIS.times(-0.1))).isLessThan(1e-14);
        assertThat(Turns.between(to, to).norm()).isLessThan(1e-16);
    }

    /** Around 0.002 rad the way in which they are computed changes. */
    @ParameterizedTest
    @ValueSource(doubles = {1e-11, 1e-6, 1e-3, 1.9999e-3, 2.0001e-3, 0.1, 1})
    void turnsOfEverySizeKeepIt(double angle) {
        Vec3 turn = AXIS.times(angle);
        Quat quaternion = Turns.of(turn);
        Vec3 axis = new Vec3(quaternion.x(), quaternion.y(), quaternion.z());
        double sine = StrictMath.sin(angle / 2);
        assertThat(axis.distance(AXIS.times(sine))).isLessThan(4e-16 * sine);
        assertThat(quaternion.w()).isCloseTo(StrictMath.cos(angle / 2), within(1.2e-16));
        assertThat(Turns.between(Quat.IDENTITY, quaternion).distance(turn))
                .isLessThan(8e-16 * angle);
        Quat longer = new Quat(2 * quaternion.w(), 2 * axis.x(), 2 * axis.y(), 2 * axis.z());
        assertThat(Turns.between(Quat.IDENTITY, longer).distance(turn)).isLessThan(8e-16 * angle);
    }
}
