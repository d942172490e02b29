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

class BoxBoxContactTest {
    private static final Box CUBE = new Box(new Vec3(2, 2, 2));
    private static final Box GROUND = new Box(new Vec3(100, 100, 2));
    private static final Pose ORIGIN = new Pose();
    private static final Vec3 UP = new Vec3(0, 0, 1);

    private final BoxBox query = new BoxBox();

    /** Two boxes that overlap. */
    private record Pair(Box a, Pose poseA, Box b, Pose poseB) {
        static Pair drawn(Draws draws) {
            Pair pair =
                    new Pair(
                            new Box(draws.vector(0.2, 2)),
                            Pose.of(draws.vector(1), draws.orientation()),
                            new Box(draws.vector(0.2, 2)),
                            Pose.of(draws.vector(1), draws.orientation()));
            return pair.overlapsWhenMoved(Vec3.ZERO) ? pair : drawn(draws);
        }

        boolean overlapsWhenMoved(Vec3 way) {
            Pose moved = Pose.of(poseA.position().plus(way), poseA.orientation());
            return new BoxBox().overlap(a, moved, b, poseB);
        }

        /** How far a must go along a unit vector to be clear of b. */
        double wayOut(Vec3 n) {
            double bTop = Double.NEGATIVE_INFINITY;
            double aBottom = Double.POSITIVE_INFINITY;
            for (int corner = 0; corner < 8; corner++) {
                bTop = Math.max(bTop, corner(b, poseB, corner).dot(n));
                aBottom = Math.min(aBottom, corner(a, poseA, corner).dot(n));
            }
            return bTop - aBottom;
        }

        private static Vec3 corner(Box box, Pose pose, int index) {
            Vec3 half = box.halfSize();
            Vec3 corner =
                    new Vec3(
                            (index & 1) == 0 ? half.x() : -half.x(),
                            (index & 2) == 0 ? half.y() : -half.y(),
                            (index & 4) == 0 ? half.z() : -half.z());
            return pose.orientation().rotate(corner).plus(pose.position());
        }
    }

    @ParameterizedTest(name = "seed {0}")
    @ValueSource(longs = {1, 2, 3, 4, 5, 6, 7, 8})
    void movedByTheDepthAlongTheNormalTheyJustPart(long seed) {
        Draws draws = new Draws(seed);
        for (int i = 0; i < 100; i++) {
            Pair pair = Pair.drawn(draws);
            ContactPoint contact = query.contact(pair.a, pair.poseA, pair.b, pair.poseB);
            assertThat(contact.normal().norm()).isCloseTo(1, within(1e-12));
            assertThat(contact.depth()).isCloseTo(pair.wayOut(contact.normal()), within(1e-12));
            Vec3 way = contact.normal().times(contact.depth());
            assertThat(pair.overlapsWhenMoved(way.plus(contact.normal().times(1e-7)))).isFalse();
            assertThat(pair.overlapsWhenMoved(way.times(0.98).minus(contact.normal().times(1e-5))))
                    .isTrue();
        }
    }

    @ParameterizedTest(name = "seed {0}")
    @ValueSource(longs = {1, 2, 3, 4, 5, 6, 7, 8})
    void noOtherDirectionPartsThemMuchSooner(long seed) {
        Draws draws = new Draws(seed);
        for (int i = 0; i < 20; i++) {
            Pair pair = Pair.drawn(draws);
            ContactPoint contact = query.contact(pair.a, pair.poseA, pair.b, pair.poseB);
            for (int j = 0; j < 500; j++) {
                assertThat(pair.wayOut(draws.direction()))
                        .isGreaterThanOrEqualTo(0.98 * contact.depth() - 1e-5);
            }
        }
    }

    @ParameterizedTest(name = "seed {0}")
    @ValueSource(longs = {1, 2, 3, 4, 5, 6, 7, 8})
    void whenTheyBarelyTouchThePointLiesInBoth(long seed) {
        Draws draws = new Draws(seed);
        for (int i = 0; i < 100; i++) {
            Pair pair = barelyTouching(Pair.drawn(draws), draws.direction());
            ContactPoint contact = query.contact(pair.a, pair.poseA, pair.b, pair.poseB);
            assertThat(contact.depth()).isBetween(-1e-11, 1e-8);
            assertInside(pair.a, pair.poseA, contact.point(), 1e-5);
            assertInside(pair.b, pair.poseB, contact.point(), 1e-5);
        }
    }

    /** As the search for a collision ends: the last place on the way apart that still overlaps. */
    private static Pair barelyTouching(Pair pair, Vec3 direction) {
        double near = 0;
        double far = pair.wayOut(direction) + 1e-6;
        while (far - near > 1e-9) {
            double middle = (near + far) / 2;
            if (pair.overlapsWhenMoved(direction.times(middle))) {
                near = middle;
            } else {
                far = middle;
            }
        }
        Vec3 place = pair.poseA.position().plus(direction.times(near));
        return new Pair(pair.a, Pose.of(place, pair.poseA.orientation()), pair.b, pair.poseB);
    }

    private static void assertInside(Box box, Pose pose, Vec3 point, double slack) {
        Vec3 local = pose.orientation().rotateInverse(point.minus(pose.position()));
        Vec3 more = new Vec3(slack, slack, slack).times(2);
        assertThat(new Box(box.size().plus(more)).contains(local)).as("%s", local).isTrue();
    }

    @ParameterizedTest(name = "seed {0}")
    @ValueSource(longs = {1, 2, 3, 4, 5, 6, 7, 8})
    void exchangedBoxesGiveTheFlippedContact(long seed) {
        Draws draws = new Draws(seed);
        for (int i = 0; i < 100; i++) {
            Pair pair = Pair.drawn(draws);
            ContactPoint one = query.contact(pair.a, pair.poseA, pair.b, pair.poseB);
            ContactPoint other = query.contact(pair.b, pair.poseB, pair.a, pair.poseA);
            assertThat(other).isEqualTo(one.flipped());
        }
    }

    @Test
    void aBoxOnTheGroundIsHeldUnderItsMiddle() {
        Pose above = Pose.of(new Vec3(3, 4, 1.99), Quat.ofAxisAngle(UP, 0.3));
        ContactPoint contact = query.contact(CUBE, above, GROUND, ORIGIN);
        assertNear(contact.normal(), UP, 1e-15);
        assertThat(contact.depth()).isCloseTo(0.01, within(1e-14));
        assertNear(contact.point(), new Vec3(3, 4, 0.995), 1e-12);
    }

    @Test
    void roundingDoesNotMoveTheContactOfABoxAtRest() {
        for (int seed = 0; seed < 50; seed++) {
            Quat tilt = Quat.ofAxisAngle(new Draws(seed).direction(), 1e-9);
            Pose above = Pose.of(new Vec3(3, 4, 2), tilt);
            ContactPoint contact = query.contact(CUBE, above, GROUND, ORIGIN);
            assertNear(contact.normal(), UP, 1e-8);
            assertNear(contact.point(), new Vec3(3, 4, 1), 1e-8);
        }
    }

    @Test
    void aBoxThatOverhangsIsHeldWhereItRests() {
        Pose overhanging = Pose.of(new Vec3(50.5, 0, 2), Quat.IDENTITY);
        ContactPoint contact = query.contact(CUBE, overhanging, GROUND, ORIGIN);
        assertNear(contact.normal(), UP, 1e-15);
        assertNear(contact.point(), new Vec3(49.75, 0, 1), 1e-12);
    }

    @Test
    void aCornerTouchesAtTheCorner() {
        Quat onCorner =
                Quat.ofAxisAngle(new Vec3(1, -1, 0), StrictMath.acos(1 / Math.sqrt(3))).conjugate();
        double height = 1 + Math.sqrt(3) - 1e-3;
        Pose above = Pose.of(new Vec3(3, 4, height), onCorner);
        ContactPoint contact = query.contact(CUBE, above, GROUND, ORIGIN);
        assertNear(contact.normal(), UP, 1e-12);
        assertThat(contact.depth()).isCloseTo(1e-3, within(1e-12));
        assertNear(contact.point(), new Vec3(3, 4, 1), 2e-3);
    }

    @Test
    void crossedEdgesTouchWhereTheyCross() {
        Box rod = new Box(new Vec3(10, 1, 1));
        Quat alongX = Quat.ofAxisAngle(new Vec3(1, 0, 0), Math.PI / 4);
        Quat alongY = Quat.ofAxisAngle(UP, Math.PI / 2).times(alongX);
        double height = Math.sqrt(2) - 0.01;
        Pose above = Pose.of(new Vec3(2, 1, height), alongY);
        ContactPoint contact = query.contact(rod, above, rod, Pose.of(Vec3.ZERO, alongX));
        assertNear(contact.normal(), UP, 1e-12);
        assertThat(contact.depth()).isCloseTo(0.01, within(1e-12));
        assertNear(contact.point(), new Vec3(2, 0, height / 2), 1e-12);
    }

    @Test
    void concentricBoxesPartThroughTheNearestFaces() {
        Box slab = new Box(new Vec3(5, 1, 5));
        ContactPoint contact = query.contact(CUBE, ORIGIN, slab, ORIGIN);
        assertThat(Math.abs(contact.normal().y())).isEqualTo(1);
        assertThat(contact.depth()).isEqualTo(1.5);
        assertNear(contact.point(), Vec3.ZERO, 0.75);
        assertThat(query.contact(CUBE, ORIGIN, CUBE, ORIGIN).depth()).isEqualTo(2);
    }

    @Test
    void boxesThatNearlyTouchHaveANegativeDepth() {
        Pose above = Pose.of(new Vec3(3, 4, 2.25), Quat.IDENTITY);
        ContactPoint contact = query.contact(CUBE, above, GROUND, ORIGIN);
        assertNear(contact.normal(), UP, 1e-15);
        assertThat(contact.depth()).isEqualTo(-0.25);
        assertNear(contact.point(), new Vec3(3, 4, 1.125), 1e-12);
    }

    @Test
    void boxesCornerToCornerApartMeetBetweenTheCorners() {
        Pose beyond = Pose.of(new Vec3(2.1, 2.1, 2.1), Quat.IDENTITY);
        ContactPoint contact = query.contact(CUBE, beyond, CUBE, ORIGIN);
        assertThat(contact.depth()).isCloseTo(-0.1, within(1e-12));
        assertNear(contact.point(), new Vec3(1.05, 1.05, 1.05), 0.1);
    }
}
