package org.auvsim.experiments.vehicle;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static org.assertj.core.data.Percentage.withPercentage;

import org.auvsim.core.actuator.Propulsor;
import org.auvsim.core.entity.MotionAxis;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.volume.Capsule;
import org.junit.jupiter.api.Test;

import java.util.List;

/** Rules of thumb against published values and closed forms. */
class EstimatesTest {
    @Test
    void aBallCarriesHalfOfWhatItDisplaces() {
        Ellipsoid ball = new Ellipsoid(0.3, 0.3, 0.3);

        assertThat(ball.linear(1000).x()).isCloseTo(500 * ball.volume(), within(1e-9));
        assertThat(ball.angular(1000).norm()).isZero();
    }

    /** Lamb's k1, k2 and k' of the spheroid of the MSS toolbox' REMUS. */
    @Test
    void aSpheroidHasLambsFactors() {
        double a = 0.80768;
        double b = 0.09591;
        Ellipsoid spheroid = new Ellipsoid(a, b, b);
        double mass = 1025 * spheroid.volume();
        double inertia = mass * (a * a + b * b) / 5;

        assertThat(spheroid.linear(1025).x() / mass).isCloseTo(0.0270, within(5e-5));
        assertThat(spheroid.linear(1025).y() / mass).isCloseTo(0.9487, within(5e-5));
        assertThat(spheroid.angular(1025).y() / inertia).isCloseTo(0.8507, within(5e-5));
        assertThat(spheroid.angular(1025).z()).isEqualTo(spheroid.angular(1025).y());
        assertThat(spheroid.angular(1025).x()).isZero();
    }

    /** Broadside on, a disc of radius a carries 8/3 rho a^3 (Lamb, article 108). */
    @Test
    void aFlatEllipsoidIsADisc() {
        Ellipsoid disc = new Ellipsoid(0.5, 0.5, 1e-5);

        assertThat(disc.linear(1000).z()).isCloseTo(8000.0 / 3 * 0.125, withPercentage(0.01));
    }

    @Test
    void stripsOfALongCapsuleAreCylindersWithRoundEnds() {
        Hull hull = Hull.of(new Capsule(0.1, 1.6));
        StripTheory strips = new StripTheory(hull, 1000);
        double volume = Math.PI * 0.01 * 1.6 + 4 * Math.PI / 3 * 0.001;

        assertThat(hull.isSlender()).isTrue();
        assertThat(strips.addedMass()).isCloseTo(1000 * volume, withPercentage(0.01));
        assertThat(strips.drag())
                .isCloseTo(550 * (0.2 * 1.6 + Math.PI * 0.01), withPercentage(0.01));
    }

    @Test
    void aCourseMayBeNeutral() {
        assertThat(VehicleSheet.course(0, "sideways")).startsWith("neutral sideways");
        assertThat(VehicleSheet.course(-1e-9, "sideways")).startsWith("neutral sideways");
        assertThat(VehicleSheet.course(1, "sideways")).contains("unstable", "doubles in 0.693 s");
        assertThat(VehicleSheet.course(-1, "sideways")).startsWith("stable sideways: halves in");
    }

    @Test
    void twoThrustersAbreastPushAndTurnAndDoNothingElse() {
        Vec3 ahead = new Vec3(1, 0, 0);
        ThrustAllocation pair =
                ThrustAllocation.of(
                        List.of(
                                new Propulsor("port", 1, 0, new Vec3(-1, 0.3, 0), ahead),
                                new Propulsor("starboard", 1, 0, new Vec3(-1, -0.3, 0), ahead)));

        assertThat(pair.rank()).isEqualTo(2);
        assertThat(pair.free()).containsExactly(MotionAxis.SURGE, MotionAxis.YAW);
        assertThat(ThrustAllocation.of(List.of()).rank()).isZero();
    }
}
