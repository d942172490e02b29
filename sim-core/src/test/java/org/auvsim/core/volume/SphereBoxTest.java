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

class SphereBoxTest {
    private static final Box BOX = new Box(new Vec3(2, 4, 6));

    private final SphereBox query = new SphereBox();

    /**
     * A point of a convex set is the one nearest to c exactly if no point of the set, so no corner
     * of the box, lies beyond the plane through it across the way to c.
     */
    @ParameterizedTest(name = "seed {0}")
    @ValueSource(longs = {1, 2, 3, 4, 5, 6, 7, 8})
    void theContactIsTheBoxsNearestPoint(long seed) {
        Draws draws = new Draws(seed);
        for (int i = 0; i < 100; i++) {
            Sphere sphere = new Sphere(draws.number(0.1, 3));
            Pose ball = Pose.of(draws.direction().times(draws.number(3.8, 6)), Quat.IDENTITY);
            Pose pose = Pose.of(Vec3.ZERO, draws.orientation());
            ContactPoint contact = query.contact(sphere, ball, BOX, pose);
            Vec3 nearest = contact.point();
            Vec3 local = pose.orientation().rotateInverse(nearest);
            assertThat(new Box(BOX.size().times(1 + 1e-12)).contains(local)).isTrue();
            Vec3 toCentre = ball.position().minus(nearest);
            for (int corner = 0; corner < 8; corner++) {
                Vec3 beyond = corner(corner, pose.orientation()).minus(nearest);
                assertThat(beyond.dot(toCentre)).isLessThan(1e-12);
            }
            assertNear(contact.normal(), toCentre.normalized(), 1e-12);
            assertThat(contact.depth()).isCloseTo(sphere.radius() - toCentre.norm(), within(1e-12));
            assertThat(query.overlap(sphere, ball, BOX, pose)).isEqualTo(contact.depth() >= 0);
        }
    }

    private static Vec3 corner(int index, Quat turn) {
        Vec3 half = BOX.halfSize();
        return turn.rotate(
                new Vec3(
                        (index & 1) == 0 ? half.x() : -half.x(),
                        (index & 2) == 0 ? half.y() : -half.y(),
                        (index & 4) == 0 ? half.z() : -half.z()));
    }

    @ParameterizedTest(name = "seed {0}")
    @ValueSource(longs = {1, 2, 3, 4, 5, 6, 7, 8})
    void aBallWhoseCentreIsInsideLeavesThroughTheNearestFace(long seed) {
        Draws draws = new Draws(seed);
        Quat turn = draws.orientation();
        Vec3 local = new Vec3(draws.number(0.6, 1), draws.number(-1, 1), draws.number(-1, 1));
        Pose pose = Pose.of(draws.vector(5), turn);
        Pose ball = Pose.of(turn.rotate(local).plus(pose.position()), Quat.IDENTITY);
        ContactPoint contact = query.contact(new Sphere(0.5), ball, BOX, pose);
        assertNear(contact.normal(), turn.rotate(new Vec3(1, 0, 0)), 1e-12);
        assertThat(contact.depth()).isCloseTo(0.5 + 1 - local.x(), within(1e-12));
        Vec3 parted = ball.position().plus(contact.normal().times(contact.depth() + 1e-9));
        assertThat(query.overlap(new Sphere(0.5), ball, BOX, pose)).isTrue();
        assertThat(query.overlap(new Sphere(0.5), Pose.of(parted, turn), BOX, pose)).isFalse();
    }

    @Test
    void aBallTouchesAFaceAnEdgeAndACorner() {
        Pose origin = new Pose();
        Sphere five = new Sphere(5);
        assertThat(query.overlap(five, at(6, 0, 0), BOX, origin)).isTrue();
        assertThat(query.overlap(five, at(6.001, 0, 0), BOX, origin)).isFalse();
        assertThat(query.overlap(five, at(1 + 3, 2 + 4, 0), BOX, origin)).isTrue();
        assertThat(query.overlap(five, at(1 + 3, 2 + 4.001, 0), BOX, origin)).isFalse();
        Sphere seven = new Sphere(7);
        assertThat(query.overlap(seven, at(1 + 2, 2 + 3, 3 + 6), BOX, origin)).isTrue();
        assertThat(query.overlap(seven, at(1 + 2, 2 + 3, 3 + 6.001), BOX, origin)).isFalse();
    }

    private static Pose at(double x, double y, double z) {
        return Pose.of(new Vec3(x, y, z), Quat.IDENTITY);
    }
}
