package org.auvsim.core.volume;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static org.auvsim.core.math.Near.assertNear;

import org.auvsim.core.math.Draws;
import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import java.util.stream.Stream;

class ManifoldTest {
    private static final double MARGIN = 1e-3;
    private static final Vec3 UP = new Vec3(0, 0, 1);
    private static final Box CUBE = new Box(new Vec3(2, 2, 2));
    private static final Quat SOME = Quat.ofAxisAngle(UP, 0.3);

    private final PairQueries queries = PairQueries.standard();
    private final Manifold found = new Manifold();

    /** Something flat with its top at z = 0, and where it is. */
    record Floor(Volume volume, Pose pose) {}

    static Stream<Floor> floors() {
        return Stream.of(
                new Floor(new HalfSpace(), new Pose()),
                new Floor(
                        new Box(new Vec3(100, 90, 2)), Pose.of(new Vec3(1, 2, -1), Quat.IDENTITY)));
    }

    private List<Vec3> touch(Volume volume, Vec3 place, Quat turn, Floor floor) {
        queries.manifold(volume, Pose.of(place, turn), floor.volume, floor.pose, MARGIN, found);
        return points(found);
    }

    private static List<Vec3> points(Manifold m) {
        return IntStream.range(0, m.count).mapToObj(i -> new Vec3(m.x[i], m.y[i], m.z[i])).toList();
    }

    private void allAre(double gap, Vec3 normal) {
        for (int i = 0; i < found.count; i++) {
            assertThat(found.gap[i]).isCloseTo(gap, within(1e-14));
            assertNear(new Vec3(found.nx[i], found.ny[i], found.nz[i]), normal, 1e-14);
        }
    }

    @ParameterizedTest
    @MethodSource("floors")
    void aBoxStandsOnItsFourCorners(Floor floor) {
        for (double gap : new double[] {1e-4, 0, -1e-4}) {
            List<Vec3> points = touch(CUBE, new Vec3(3, 4, 1 + gap), SOME, floor);
            List<Vec3> expected = new ArrayList<>();
            for (Vec3 corner : new Vec3[] {new Vec3(1, 1, 0), new Vec3(1, -1, 0)}) {
                Vec3 turned = SOME.rotate(corner);
                expected.add(new Vec3(3, 4, gap / 2).plus(turned));
                expected.add(new Vec3(3, 4, gap / 2).minus(turned));
            }
            assertSame(points, expected);
            allAre(gap, UP);
        }
    }

    private static void assertSame(List<Vec3> points, List<Vec3> expected) {
        assertThat(points).hasSameSizeAs(expected);
        for (Vec3 e : expected) {
            assertThat(points).as("near %s", e).anyMatch(p -> p.distance(e) < 1e-13);
        }
    }

    @ParameterizedTest
    @MethodSource("floors")
    void aLyingCapsuleTouchesUnderBothEnds(Floor floor) {
        Capsule capsule = new Capsule(0.5, 3);
        List<Vec3> points = touch(capsule, new Vec3(0, 0, 0.5 + 1e-4), Quat.IDENTITY, floor);
        assertSame(points, List.of(new Vec3(1.5, 0, 5e-5), new Vec3(-1.5, 0, 5e-5)));
        allAre(1e-4, UP);
    }

    @ParameterizedTest
    @MethodSource("floors")
    void aSphereTouchesAtOnePoint(Floor floor) {
        assertSame(
                touch(new Sphere(0.5), new Vec3(3, 4, 0.5), SOME, floor),
                List.of(new Vec3(3, 4, 0)));
        allAre(0, UP);
    }

    @ParameterizedTest
    @MethodSource("floors")
    void whatIsFartherThanTheMarginHasNoPoint(Floor floor) {
        for (Volume volume : List.of(CUBE, new Capsule(1, 2), new Sphere(1))) {
            assertThat(touch(volume, new Vec3(0, 0, 1 + 1.01 * MARGIN), SOME, floor)).isEmpty();
        }
    }

    @ParameterizedTest
    @MethodSource("floors")
    void aTiltedBoxTouchesAlongAnEdgeThenAtACorner(Floor floor) {
        Quat onEdge = SOME.times(Quat.ofAxisAngle(new Vec3(1, 0, 0), Math.PI / 4));
        assertThat(touch(CUBE, new Vec3(0, 0, Math.sqrt(2)), onEdge, floor)).hasSize(2);
        Quat onCorner = Quat.ofAxisAngle(new Vec3(1, -1, 0), StrictMath.acos(1 / Math.sqrt(3)));
        assertThat(touch(CUBE, new Vec3(0, 0, Math.sqrt(3)), onCorner.conjugate(), floor))
                .hasSize(1);
        assertNear(points(found).getFirst(), Vec3.ZERO, 1e-12);
    }

    @Test
    void crossedEdgesTouchWhereTheyCross() {
        Box rod = new Box(new Vec3(10, 1, 1));
        Quat alongX = Quat.ofAxisAngle(new Vec3(1, 0, 0), Math.PI / 4);
        Quat alongY = Quat.ofAxisAngle(UP, Math.PI / 2).times(alongX);
        for (double gap : new double[] {1e-4, 1e-9, -1e-9, -1e-4}) {
            Pose above = Pose.of(new Vec3(2, 1, Math.sqrt(2) + gap), alongY);
            queries.manifold(rod, above, rod, Pose.of(Vec3.ZERO, alongX), MARGIN, found);
            assertThat(found.count).isEqualTo(1);
            assertThat(found.gap[0]).isCloseTo(gap, within(1e-12));
            assertNear(points(found).getFirst(), new Vec3(2, 0, Math.sqrt(0.5) + gap / 2), 1e-12);
        }
    }

    @Test
    void aBoxThatOverhangsIsHeldOnlyWhereTheFloorIs() {
        Floor floor =
                new Floor(
                        new Box(new Vec3(100, 90, 2)), Pose.of(new Vec3(0, 0, -1), Quat.IDENTITY));
        List<Vec3> points = touch(CUBE, new Vec3(50.5, 0, 1), Quat.IDENTITY, floor);
        assertSame(
                points,
                List.of(
                        new Vec3(49.5, 1, 0),
                        new Vec3(50, 1, 0),
                        new Vec3(50, -1, 0),
                        new Vec3(49.5, -1, 0)));
    }

    @Test
    void capsulesSideBySideTouchAlongTheirCommonStretch() {
        Capsule capsule = new Capsule(0.5, 4);
        queries.manifold(
                capsule,
                Pose.of(new Vec3(1, 0, 1), Quat.IDENTITY),
                capsule,
                new Pose(),
                MARGIN,
                found);
        assertSame(points(found), List.of(new Vec3(-1, 0, 0.5), new Vec3(2, 0, 0.5)));
        allAre(0, UP);
    }

    @ParameterizedTest(name = "seed {0}")
    @ValueSource(longs = {1, 2, 3, 4, 5, 6, 7, 8})
    void pointsLieBetweenTheSurfacesAndTheDeepestIsTheDistance(long seed) {
        Draws draws = new Draws(seed);
        Separation nearest = new Separation();
        for (int i = 0; i < 300; i++) {
            Volume a = ConvexDistanceTest.drawn(draws, i % 3);
            Volume b = ConvexDistanceTest.drawn(draws, i / 3 % 3);
            Pose poseA = Pose.of(draws.vector(4), draws.orientation());
            Pose poseB = Pose.of(Vec3.ZERO, draws.orientation());
            double far = queries.distance(a, poseA, b, poseB, nearest);
            if (far > MARGIN / 2) {
                Vec3 n = new Vec3(nearest.nx, nearest.ny, nearest.nz);
                Vec3 near = poseA.position().minus(n.times(far - MARGIN / 2));
                Pose moved = Pose.of(near, poseA.orientation());
                queries.manifold(a, moved, b, poseB, MARGIN, found);
                assertThat(found.count).isPositive();
                double least = Arrays.stream(found.gap, 0, found.count).min().orElseThrow();
                assertThat(least).isCloseTo(MARGIN / 2, within(2e-2 * MARGIN));
                betweenSurfaces(a, moved, b, poseB);
            }
        }
    }

    private void betweenSurfaces(Volume a, Pose poseA, Volume b, Pose poseB) {
        Sphere point = new Sphere(Double.MIN_NORMAL);
        for (Vec3 p : points(found)) {
            Pose place = Pose.of(p, Quat.IDENTITY);
            assertThat(EnumeratedDistance.between(point, place, a, poseA)).isBetween(0.0, MARGIN);
            assertThat(EnumeratedDistance.between(point, place, b, poseB)).isBetween(0.0, MARGIN);
        }
    }

    @ParameterizedTest(name = "seed {0}")
    @ValueSource(longs = {1, 2, 3, 4, 5, 6, 7, 8})
    void exchangedVolumesGiveTheSamePointsToTheBit(long seed) {
        Draws draws = new Draws(seed);
        Manifold other = new Manifold();
        for (int i = 0; i < 300; i++) {
            Volume a = ConvexDistanceTest.drawn(draws, i % 3);
            Volume b = ConvexDistanceTest.drawn(draws, i / 3 % 3);
            Pose poseA = Pose.of(draws.vector(1), draws.orientation());
            Pose poseB = Pose.of(draws.vector(1), draws.orientation());
            queries.manifold(a, poseA, b, poseB, MARGIN, found);
            queries.manifold(b, poseB, a, poseA, MARGIN, other);
            assertThat(points(other)).isEqualTo(points(found));
            other.flip();
            assertThat(Arrays.copyOf(other.nx, other.count))
                    .containsExactly(Arrays.copyOf(found.nx, found.count));
            assertThat(Arrays.copyOf(other.gap, other.count))
                    .containsExactly(Arrays.copyOf(found.gap, found.count));
        }
    }
}
