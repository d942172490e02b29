package org.auvsim.core.volume;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;
import static org.auvsim.core.math.Near.assertNear;

import org.auvsim.core.math.Draws;
import org.auvsim.core.math.Mat3;
import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.util.ArrayList;
import java.util.List;

class CompoundTest {
    private static final Quat SOME = Quat.ofAxisAngle(new Vec3(1, 2, 3), 0.7);

    private final PairQueries queries = PairQueries.standard();
    private final Separation found = new Separation();

    private static Part at(Volume volume, double x, double y, double z) {
        return new Part(volume, new Vec3(x, y, z), Quat.IDENTITY);
    }

    private static Compound drawn(Draws draws) {
        List<Part> parts = new ArrayList<>();
        for (int kind = 0; kind < 3; kind++) {
            parts.add(
                    new Part(
                            ConvexDistanceTest.drawn(draws, kind),
                            draws.vector(1.5),
                            draws.orientation()));
        }
        return new Compound(parts);
    }

    @Test
    void twoBallsAreADumbbell() {
        Sphere ball = new Sphere(0.5);
        Compound dumbbell = new Compound(List.of(at(ball, 2, 0, 0), at(ball, -2, 0, 0)));
        double own = 2.0 / 5 * 3 * 0.25;
        assertNear(dumbbell.inertia(6), Mat3.diagonal(2 * own, 2 * own + 24, 2 * own + 24), 1e-12);
        assertNear(dumbbell.centreOfMass(), Vec3.ZERO, 1e-15);
        assertThat(dumbbell.boundingRadius()).isEqualTo(2.5);
        assertThat(dumbbell.isBounded()).isTrue();
    }

    /** A 2 x 1 x 1 box along x and a 1 x 1 x 1 box over its left end: masses 2 and 1. */
    @Test
    void anAngleHasItsCentreAsideAndProductsOfInertia() {
        Compound angle =
                new Compound(
                        List.of(
                                at(new Box(new Vec3(2, 1, 1)), 1, 0.5, 0.5),
                                at(new Box(new Vec3(1, 1, 1)), 0.5, 1.5, 0.5)));
        assertNear(angle.centreOfMass(), new Vec3(2.5 / 3, 2.5 / 3, 0.5), 1e-15);
        // Parallel axes: the parts' centres are (1/6, -1/3, 0) and (-1/3, 2/3, 0) from it.
        double xx = 2 * (2.0 / 12) + 2.0 / 9 + 2.0 / 12 + 4.0 / 9;
        double yy = 2 * (5.0 / 12) + 2.0 / 36 + 2.0 / 12 + 1.0 / 9;
        double zz = 2 * (5.0 / 12) + 2 * (1.0 / 36 + 1.0 / 9) + 2.0 / 12 + 5.0 / 9;
        double xy = 2 * (1.0 / 18) + 2.0 / 9;
        assertNear(angle.inertia(3), new Mat3(xx, xy, 0, xy, yy, 0, 0, 0, zz), 1e-14);
    }

    @Test
    void halvesOfABoxMakeTheBox() {
        Box whole = new Box(new Vec3(2, 1, 0.5));
        Box half = new Box(new Vec3(1, 1, 0.5));
        Quat turn = SOME;
        Compound halves =
                new Compound(
                        List.of(
                                new Part(half, turn.rotate(new Vec3(0.5, 0, 0)), turn),
                                new Part(half, turn.rotate(new Vec3(-0.5, 0, 0)), turn)));
        Mat3 expected = turn.toMatrix().times(whole.inertia(5)).times(turn.toMatrix().transposed());
        assertNear(halves.inertia(5), expected, 1e-14);
        assertThat(halves.boundingRadius()).isCloseTo(whole.boundingRadius(), within(1e-15));
        assertThat(halves.inertia(5).isSymmetric()).isTrue();
    }

    @ParameterizedTest(name = "seed {0}")
    @ValueSource(longs = {1, 2, 3, 4, 5, 6, 7, 8})
    void distanceIsThatOfTheNearestParts(long seed) {
        Draws draws = new Draws(seed);
        for (int i = 0; i < 40; i++) {
            Compound a = drawn(draws);
            Compound b = drawn(draws);
            Pose poseA = Pose.of(draws.vector(4), draws.orientation());
            Pose poseB = Pose.of(draws.vector(4), draws.orientation());
            double least = Double.POSITIVE_INFINITY;
            for (Part p : a.part()) {
                for (Part q : b.part()) {
                    least =
                            Math.min(
                                    least,
                                    EnumeratedDistance.between(
                                            p.volume(),
                                            placed(p, poseA),
                                            q.volume(),
                                            placed(q, poseB)));
                }
            }
            double distance = queries.distance(a, poseA, b, poseB, found);
            if (least > 0) {
                assertThat(distance).isCloseTo(least, within(1e-12));
            } else {
                assertThat(distance).isLessThanOrEqualTo(least + 1e-12);
            }
        }
    }

    private static Pose placed(Part part, Pose pose) {
        return Pose.of(
                pose.orientation().rotate(part.position()).plus(pose.position()),
                pose.orientation().times(part.orientation()).normalized());
    }

    @ParameterizedTest(name = "seed {0}")
    @ValueSource(longs = {1, 2, 3, 4, 5, 6, 7, 8})
    void itsBoundsTouchItOnAllSides(long seed) {
        Draws draws = new Draws(seed);
        double[] bounds = new double[8];
        for (int i = 0; i < 50; i++) {
            Volume volume = i % 4 == 3 ? drawn(draws) : ConvexDistanceTest.drawn(draws, i % 4);
            Pose pose = Pose.of(draws.vector(4), draws.orientation());
            volume.bounds(pose, bounds, 1);
            for (int side = 0; side < 6; side++) {
                Vec3 out = axis(side % 3).times(side < 3 ? -1 : 1);
                Pose wall = Pose.of(axis(side % 3).times(bounds[1 + side]), wallBeyond(out));
                double gap = queries.distance(volume, pose, new HalfSpace(), wall, found);
                assertThat(gap).as("%s", volume).isCloseTo(0, within(1e-12));
            }
        }
    }

    private static Vec3 axis(int k) {
        return new Vec3(k == 0 ? 1 : 0, k == 1 ? 1 : 0, k == 2 ? 1 : 0);
    }

    /** The orientation of a half-space that fills what is beyond a side. */
    private static Quat wallBeyond(Vec3 out) {
        Vec3 up = new Vec3(0, 0, 1);
        Vec3 axis = out.cross(up);
        if (axis.norm() > 0) {
            return Quat.ofAxisAngle(axis, Math.PI / 2);
        }
        return out.z() < 0 ? Quat.IDENTITY : Quat.ofAxisAngle(new Vec3(1, 0, 0), Math.PI);
    }

    @ParameterizedTest(name = "seed {0}")
    @ValueSource(longs = {1, 2, 3, 4})
    void exchangedVolumesGiveTheSameToTheBit(long seed) {
        Draws draws = new Draws(seed);
        Separation other = new Separation();
        for (int i = 0; i < 50; i++) {
            Compound a = drawn(draws);
            Volume b = i % 4 == 3 ? drawn(draws) : ConvexDistanceTest.drawn(draws, i % 4);
            Pose poseA = Pose.of(draws.vector(3), draws.orientation());
            Pose poseB = Pose.of(draws.vector(3), draws.orientation());
            double one = queries.distance(a, poseA, b, poseB, found);
            assertThat(queries.distance(b, poseB, a, poseA, other)).isEqualTo(one);
            assertThat(new Vec3(other.nx, other.ny, other.nz).negated())
                    .isEqualTo(new Vec3(found.nx, found.ny, found.nz));
            assertThat(new Vec3(other.px, other.py, other.pz))
                    .isEqualTo(new Vec3(found.px, found.py, found.pz));
        }
    }

    @Test
    void aTableStandsOnItsLegs() {
        Box leg = new Box(new Vec3(0.2, 0.2, 1));
        List<Part> parts = new ArrayList<>();
        parts.add(at(new Box(new Vec3(2, 2, 0.1)), 0, 0, 1.05));
        for (int i = 0; i < 4; i++) {
            parts.add(at(leg, i % 2 == 0 ? 0.9 : -0.9, i / 2 == 0 ? 0.9 : -0.9, 0.5));
        }
        Manifold manifold = new Manifold();
        queries.manifold(
                new Compound(parts), new Pose(), new HalfSpace(), new Pose(), 1e-3, manifold);
        assertThat(manifold.count).isEqualTo(Manifold.MAXIMUM);
        for (int i = 0; i < 4; i++) {
            Vec3 foot = new Vec3(i % 2 == 0 ? 1 : -1, i / 2 == 0 ? 1 : -1, 0);
            boolean isStoodOn = false;
            for (int k = 0; k < manifold.count; k++) {
                Vec3 point = new Vec3(manifold.x[k], manifold.y[k], manifold.z[k]);
                isStoodOn |= point.distance(foot) < 0.3;
            }
            assertThat(isStoodOn).as("foot %s", foot).isTrue();
        }
    }

    @Test
    void aCompoundWithoutPartsIsRefused() {
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new Compound(List.of()))
                .withMessage("a compound needs at least one part, but has none; add a <part>");
    }

    @Test
    void aPartThatIsNotConvexOrHasAHoleInItsNumbersIsRefused() {
        assertThatIllegalArgumentException()
                .isThrownBy(() -> at(new HalfSpace(), 0, 0, 0))
                .withMessage(
                        "a part of a compound must be a sphere, a capsule or a box, but is a"
                                + " half-space");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> at(new Sphere(1), 0, Double.NaN, 0))
                .withMessage(
                        "the position of a compound's part must be finite, but is (0.0, NaN, 0.0)"
                                + " m");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new Part(new Sphere(1), Vec3.ZERO, new Quat(Double.NaN, 0, 0, 0)))
                .withMessage(
                        "the orientation of a compound's part must be finite, but is (NaN, 0.0,"
                                + " 0.0, 0.0)");
    }
}
