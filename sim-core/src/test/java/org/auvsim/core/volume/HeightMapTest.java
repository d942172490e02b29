package org.auvsim.core.volume;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;
import static org.auvsim.core.math.Near.assertNear;

import org.auvsim.core.math.Draws;
import org.auvsim.core.math.Numbers;
import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.function.DoubleBinaryOperator;

class HeightMapTest {
    private static final double SPACING = 0.5;
    private static final int SIZE = 17;
    private static final double MARGIN = 1e-3;

    private final PairQueries queries = PairQueries.standard();
    private final Separation found = new Separation();
    private final Manifold points = new Manifold();

    private static HeightMap map(DoubleBinaryOperator height) {
        List<HeightMap.Row> rows = new ArrayList<>();
        for (int j = 0; j < SIZE; j++) {
            double[] heights = new double[SIZE];
            for (int i = 0; i < SIZE; i++) {
                heights[i] = height.applyAsDouble(i * SPACING, j * SPACING);
            }
            rows.add(new HeightMap.Row(Numbers.of(heights)));
        }
        return new HeightMap(SPACING, rows);
    }

    private static HeightMap hills(Draws draws) {
        return map((x, y) -> draws.number(0, 1));
    }

    private static Volume drawn(Draws draws, int kind) {
        return kind < 3
                ? ConvexDistanceTest.drawn(draws, kind)
                : new Compound(
                        List.of(
                                new Part(
                                        ConvexDistanceTest.drawn(draws, 2),
                                        draws.vector(0.3),
                                        draws.orientation()),
                                new Part(
                                        ConvexDistanceTest.drawn(draws, 1),
                                        draws.vector(0.3),
                                        draws.orientation())));
    }

    @ParameterizedTest(name = "seed {0}")
    @ValueSource(longs = {1, 2, 3, 4, 5, 6, 7, 8})
    void aPlaneOfTrianglesIsAHalfSpace(long seed) {
        Draws draws = new Draws(seed);
        double slope = draws.number(-0.5, 0.5);
        double across = draws.number(-0.5, 0.5);
        HeightMap plane = map((x, y) -> slope * x + across * y);
        Vec3 normal = new Vec3(-slope, -across, 1).normalized();
        Vec3 axis = new Vec3(0, 0, 1).cross(normal);
        Quat lean = Quat.ofAxisAngle(axis, StrictMath.acos(normal.z()));
        Quat world = draws.orientation();
        Vec3 shift = draws.vector(3);
        Pose map = Pose.of(shift, world);
        Pose floor = Pose.of(shift, world.times(lean).normalized());
        for (int i = 0; i < 200; i++) {
            Volume volume = drawn(draws, i % 4);
            Vec3 local = new Vec3(draws.number(3, 5), draws.number(3, 5), draws.number(-1, 4));
            Pose pose = Pose.of(world.rotate(local).plus(shift), draws.orientation());
            double expected = queries.distance(volume, pose, new HalfSpace(), floor, found);
            double distance = queries.distance(volume, pose, plane, map, found);
            if (expected > 0) {
                assertThat(distance)
                        .as("%s", volume)
                        .isCloseTo(Math.min(expected, 4 * SPACING), within(1e-12));
            } else {
                assertThat(distance).as("%s", volume).isBetween(expected - 1e-12, 1e-12);
            }
            if (distance < 3.99 * SPACING && expected > 0) {
                assertNear(new Vec3(found.nx, found.ny, found.nz), world.rotate(normal), 1e-10);
            }
        }
    }

    @ParameterizedTest(name = "seed {0}")
    @ValueSource(longs = {1, 2, 3, 4, 5, 6, 7, 8})
    void distanceToHillsIsThatToTheirNearestPoint(long seed) {
        Draws draws = new Draws(seed);
        HeightMap hills = hills(draws);
        for (int i = 0; i < 12; i++) {
            Volume volume = ConvexDistanceTest.drawn(draws, i % 3);
            Vec3 place = new Vec3(draws.number(-1, 8), draws.number(-1, 8), draws.number(0.5, 3));
            Pose pose = Pose.of(place, draws.orientation());
            double sampled = sampled(volume, pose, hills);
            double distance = queries.distance(volume, pose, hills, new Pose(), found);
            if (sampled > 1e-12) {
                assertThat(distance)
                        .as("%s", volume)
                        .isBetween(
                                Math.min(sampled, 4 * SPACING) - 5e-3,
                                Math.min(sampled, 4 * SPACING) + 1e-12);
            } else {
                assertThat(distance).as("%s", volume).isLessThanOrEqualTo(0);
            }
        }
    }

    /** The least distance of points of the surface, close to each other. */
    private static double sampled(Volume volume, Pose pose, HeightMap map) {
        Sphere point = new Sphere(Double.MIN_NORMAL);
        Pose place = new Pose();
        double least = Double.POSITIVE_INFINITY;
        double step = SPACING / 25;
        double reach = volume.boundingRadius() + 2.5;
        for (double x = step * Math.floor((pose.x - reach) / step); x < pose.x + reach; x += step) {
            for (double y = step * Math.floor((pose.y - reach) / step);
                    y < pose.y + reach;
                    y += step) {
                place.x = x;
                place.y = y;
                place.z = map.height(x, y);
                least = Math.min(least, EnumeratedDistance.between(volume, pose, point, place));
            }
        }
        return least;
    }

    @Test
    void whatIsUnderTheSurfaceIsInside() {
        HeightMap hills = hills(new Draws(1));
        for (double depth : new double[] {0.5, 2, 50}) {
            for (int kind = 0; kind < 4; kind++) {
                Volume volume = drawn(new Draws(kind), kind);
                Pose pose = Pose.of(new Vec3(4.1, 3.8, -depth), Quat.IDENTITY);
                assertThat(queries.distance(volume, pose, hills, new Pose(), found)).isNegative();
                assertThat(queries.overlap(volume, pose, hills, new Pose())).isTrue();
                queries.manifold(volume, pose, hills, new Pose(), MARGIN, points);
                assertThat(points.count).isPositive();
            }
        }
    }

    @Test
    void beyondTheEdgeTheSurfaceGoesOnAsHighAsThere() {
        HeightMap map = map((x, y) -> x);
        Sphere ball = new Sphere(0.25);
        Pose beyond = Pose.of(new Vec3(100, -40, 8.5), Quat.IDENTITY);
        assertThat(queries.distance(ball, beyond, map, new Pose(), found)).isEqualTo(0.25);
        assertThat(map.contains(new Vec3(100, -40, 8))).isTrue();
        assertThat(map.contains(new Vec3(100, -40, 8.001))).isFalse();
    }

    @ParameterizedTest
    @ValueSource(doubles = {1e-4, 0, -1e-4})
    void aBoxStandsOnFourPointsOfAFlatFloor(double gap) {
        HeightMap flat = map((x, y) -> 1);
        Quat turn = Quat.ofAxisAngle(new Vec3(0, 0, 1), 0.3);
        Box box = new Box(new Vec3(2, 2, 2));
        Pose pose = Pose.of(new Vec3(3.3, 4.1, 2 + gap), turn);
        queries.manifold(box, pose, flat, new Pose(), MARGIN, points);
        assertThat(points.count).isEqualTo(4);
        for (int i = 0; i < 4; i++) {
            Vec3 corner = new Vec3(i % 2 == 0 ? 1 : -1, i / 2 == 0 ? 1 : -1, 0);
            Vec3 expected = turn.rotate(corner).plus(new Vec3(3.3, 4.1, 1 + gap / 2));
            assertThat(places()).anyMatch(p -> p.distance(expected) < 1e-12);
            assertThat(points.gap[i]).isCloseTo(gap, within(1e-12));
            assertThat(points.nz[i]).isCloseTo(1, within(1e-15));
        }
    }

    private List<Vec3> places() {
        List<Vec3> places = new ArrayList<>();
        for (int i = 0; i < points.count; i++) {
            places.add(new Vec3(points.x[i], points.y[i], points.z[i]));
        }
        return places;
    }

    @ParameterizedTest(name = "seed {0}")
    @ValueSource(longs = {1, 2, 3, 4, 5, 6, 7, 8})
    void aSphereOnAFlatFloorHasOnePointWhereverItIs(long seed) {
        Draws draws = new Draws(seed);
        HeightMap flat = map((x, y) -> 1);
        for (int i = 0; i < 100; i++) {
            double x = i % 3 == 0 ? Math.floor(draws.number(2, 10)) / 2 : draws.number(1, 5);
            double y = i % 5 == 0 ? Math.floor(draws.number(2, 10)) / 2 : draws.number(1, 5);
            Pose pose = Pose.of(new Vec3(x, y, 1.5 + draws.number(-1e-3, 1e-3)), Quat.IDENTITY);
            queries.manifold(new Sphere(0.5), pose, flat, new Pose(), MARGIN, points);
            assertThat(points.count).isEqualTo(1);
            assertThat(points.nz[0]).isCloseTo(1, within(1e-12));
        }
    }

    @Test
    void aBoxOnAPeakAndACapsuleAcrossARidgeTouchThere() {
        HeightMap peak = map((x, y) -> x == 4 && y == 4 ? 1 : 0);
        Box box = new Box(new Vec3(2, 2, 2));
        Pose above = Pose.of(new Vec3(4.2, 4.1, 2 + 1e-4), Quat.IDENTITY);
        queries.manifold(box, above, peak, new Pose(), MARGIN, points);
        assertThat(points.count).isEqualTo(1);
        assertNear(places().getFirst(), new Vec3(4, 4, 1 + 5e-5), 1e-9);

        HeightMap ridge = map((x, y) -> x == 4 ? 1 : 0);
        Capsule capsule = new Capsule(0.5, 3);
        Pose across = Pose.of(new Vec3(4.2, 4.1, 1.5 + 1e-4), Quat.IDENTITY);
        queries.manifold(capsule, across, ridge, new Pose(), MARGIN, points);
        assertThat(points.count).isEqualTo(1);
        assertNear(places().getFirst(), new Vec3(4, 4.1, 1 + 5e-5), 1e-9);
    }

    @ParameterizedTest(name = "seed {0}")
    @ValueSource(longs = {1, 2, 3, 4, 5, 6, 7, 8})
    void touchingHillsThePointsLieOnThem(long seed) {
        Draws draws = new Draws(seed);
        HeightMap hills = hills(draws);
        Sphere point = new Sphere(1e-12);
        for (int i = 0; i < 60; i++) {
            Volume volume = ConvexDistanceTest.drawn(draws, i % 3);
            Quat turn = draws.orientation();
            double x = draws.number(1, 7);
            double y = draws.number(1, 7);
            Pose pose = lowered(volume, Pose.of(new Vec3(x, y, 4), turn), hills);
            queries.manifold(volume, pose, hills, new Pose(), MARGIN, points);
            assertThat(points.count).as("%s", volume).isPositive();
            double least = Arrays.stream(points.gap, 0, points.count).min().orElseThrow();
            assertThat(least).isCloseTo(MARGIN / 2, within(MARGIN / 4));
            for (Vec3 p : places()) {
                Pose place = Pose.of(p, Quat.IDENTITY);
                assertThat(queries.distance(point, place, hills, new Pose(), found))
                        .isBetween(0.0, MARGIN);
                assertThat(queries.distance(point, place, volume, pose, found))
                        .isBetween(0.0, MARGIN);
            }
        }
    }

    /** Let down until half the margin is left. */
    private Pose lowered(Volume volume, Pose pose, HeightMap map) {
        double gap = queries.distance(volume, pose, map, new Pose(), found);
        while (gap > MARGIN / 2 * 1.001) {
            pose.z -= gap - MARGIN / 2;
            gap = queries.distance(volume, pose, map, new Pose(), found);
        }
        return pose;
    }

    @ParameterizedTest
    @ValueSource(doubles = {0, -1, Double.NaN, Double.POSITIVE_INFINITY})
    void aSpacingThatIsNoneIsRefused(double spacing) {
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new HeightMap(spacing, rows(new double[2], new double[2])))
                .withMessage(
                        "a height map's spacing must be above 0 m and finite, but is %s m"
                                .formatted(spacing));
    }

    @Test
    void missingCellsAreNamed() {
        assertThatIllegalArgumentException()
                .isThrownBy(
                        () -> new HeightMap(1, rows(new double[3], new double[3], new double[2])))
                .withMessage(
                        "row 3 of a height map has 2 heights, but row 1 has 3; give every row the"
                                + " same number");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new HeightMap(1, rows(new double[3])))
                .withMessage("a height map needs at least 2 rows of 2 heights, but has 1 of 3");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new HeightMap(1, rows(new double[1], new double[1])))
                .withMessage("a height map needs at least 2 rows of 2 heights, but has 2 of 1");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new HeightMap(1, List.of()))
                .withMessage("a height map needs at least 2 rows of 2 heights, but has 0 of 0");
    }

    @Test
    void aHeightThatIsNoNumberIsNamed() {
        assertThatIllegalArgumentException()
                .isThrownBy(
                        () -> new HeightMap(1, rows(new double[2], new double[] {0, Double.NaN})))
                .withMessage("height 2 of row 2 of a height map must be finite, but is NaN m");
    }

    @Test
    void aHeightMapHasNoMass() {
        assertThatIllegalArgumentException()
                .isThrownBy(() -> hills(new Draws(1)).inertia(1))
                .withMessage(
                        "a height map has no mass: make the object fixed and leave its mass out");
    }

    private static List<HeightMap.Row> rows(double[]... rows) {
        return Arrays.stream(rows).map(r -> new HeightMap.Row(Numbers.of(r))).toList();
    }
}
