package org.auvsim.core.volume;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static org.auvsim.core.math.Near.assertNear;

import org.auvsim.core.math.Draws;
import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class SphereSphereTest {
    private final SphereSphere query = new SphereSphere();

    @Test
    void theyTouchAtTheSumOfTheirRadii() {
        Sphere two = new Sphere(2);
        Sphere three = new Sphere(3);
        assertThat(query.overlap(two, at(0, 0, 0), three, at(0, 5, 0))).isTrue();
        assertThat(query.overlap(two, at(0, 0, 0), three, at(0, Math.nextUp(5), 0))).isFalse();
    }

    @Test
    void theContactLiesOnTheLineOfCentres() {
        ContactPoint contact =
                query.contact(new Sphere(2), at(0, 0, 4), new Sphere(3), at(0, 0, 0));
        assertNear(contact.normal(), new Vec3(0, 0, 1), 0);
        assertThat(contact.depth()).isEqualTo(1);
        assertNear(contact.point(), new Vec3(0, 0, 2.5), 1e-15);
    }

    @ParameterizedTest(name = "seed {0}")
    @ValueSource(longs = {1, 2, 3, 4})
    void movedByTheDepthAlongTheNormalTheyJustPart(long seed) {
        Draws draws = new Draws(seed);
        Sphere a = new Sphere(draws.number(0.1, 2));
        Sphere b = new Sphere(draws.number(0.1, 2));
        Pose poseA = Pose.of(draws.vector(1), draws.orientation());
        Pose poseB = Pose.of(draws.vector(1), draws.orientation());
        ContactPoint contact = query.contact(a, poseA, b, poseB);
        Vec3 parted = poseA.position().plus(contact.normal().times(contact.depth()));
        assertThat(parted.distance(poseB.position()))
                .isCloseTo(a.radius() + b.radius(), within(1e-14));
        ContactPoint other = query.contact(b, poseB, a, poseA);
        assertNear(other.normal(), contact.normal().negated(), 1e-15);
        assertNear(other.point(), contact.point(), 1e-14);
        assertThat(other.depth()).isEqualTo(contact.depth());
    }

    @Test
    void concentricSpheresPartUpward() {
        ContactPoint contact =
                query.contact(new Sphere(1), at(1, 2, 3), new Sphere(2), at(1, 2, 3));
        assertThat(contact.normal()).isEqualTo(new Vec3(0, 0, 1));
        assertThat(contact.depth()).isEqualTo(3);
    }

    private static Pose at(double x, double y, double z) {
        return Pose.of(new Vec3(x, y, z), Quat.IDENTITY);
    }
}
