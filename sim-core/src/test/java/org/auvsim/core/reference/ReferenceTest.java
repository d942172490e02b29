package org.auvsim.core.reference;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

import java.util.SplittableRandom;
import java.util.stream.LongStream;

/** The reference itself, held against closed forms. */
class ReferenceTest {
    private static final double[] ZERO = {0, 0, 0};
    private static final double[] UPRIGHT = {1, 0, 0, 0};

    /** A quarter turn about x, backward: the body's z axis is the world's y axis. */
    private static final double[] Y_UP = {Math.sqrt(0.5), -Math.sqrt(0.5), 0, 0};

    private static final double[] ROUND = {1, 1, 1};

    private static Union ball(double radius) {
        return Union.of(new Part(0, 0, 0, radius));
    }

    private static Union brick(double x, double y, double z) {
        return Union.of(new Part(x, y, z, 0));
    }

    private static FreeFlight at(double x, double y, double z, double[] orientation) {
        return new FreeFlight(new double[] {x, y, z}, ZERO, ZERO, ROUND, orientation, ZERO, 0);
    }

    private static double gap(Solid a, FreeFlight placeA, Solid b, FreeFlight placeB) {
        return new Encounter(placeA, a, placeB, b).gap(0);
    }

    @Test
    void gapsOfSimplePairs() {
        FreeFlight origin = at(0, 0, 0, UPRIGHT);
        Union rod = Union.of(new Part(0.5, 0, 0, 0.25));

        assertThat(gap(ball(0.5), origin, ball(0.25), at(0, 0.9, 0, UPRIGHT)))
                .isEqualTo(0.15, within(1e-15));
        assertThat(gap(ball(0.5), at(1, 1, 1, UPRIGHT), brick(0.5, 0.5, 0.5), origin))
                .isEqualTo(Math.sqrt(0.75) - 0.5, within(1e-15));
        assertThat(gap(rod, origin, ball(0.25), at(0.9, 0.4, 0, UPRIGHT)))
                .isEqualTo(Math.hypot(0.4, 0.4) - 0.5, within(1e-15));
        assertThat(
                        gap(
                                brick(0.5, 0.5, 0.5),
                                origin,
                                brick(0.5, 0.2, 0.1),
                                at(0, 0.8, 0.3, UPRIGHT)))
                .isEqualTo(0.1, within(1e-15));
        assertThat(gap(brick(1, 1, 1), origin, brick(0.1, 0.1, 0.1), origin)).isZero();
    }

    @Test
    void twoBoxesEdgeToEdge() {
        // Each turned by 45 degrees, about x and about y: their edges cross at right angles.
        double half = Math.sqrt(0.5);
        double c = Math.sqrt((1 + half) / 2);
        double s = Math.sqrt((1 - half) / 2);

        double gap =
                gap(
                        brick(0.5, 0.5, 0.5),
                        at(0, 0, 0, new double[] {c, s, 0, 0}),
                        brick(0.5, 0.5, 0.5),
                        at(0.1, 0.1, 1.5, new double[] {c, 0, s, 0}));

        assertThat(gap).isEqualTo(1.5 - 2 * half, within(1e-14));
    }

    static LongStream seeds() {
        return LongStream.rangeClosed(1, 200);
    }

    /** By alternating projections, which approach the nearest points of two convex bodies. */
    @ParameterizedTest(name = "seed {0}")
    @MethodSource("seeds")
    void theGapOfTwoTurnedBoxesIsThatOfTheirNearestPoints(long seed) {
        SplittableRandom random = new SplittableRandom(seed);
        Part a = new Part(random.nextDouble(), random.nextDouble(), random.nextDouble(), 0);
        Part b = new Part(random.nextDouble(), random.nextDouble(), random.nextDouble(), 0);
        Placement placeA = placement(random);
        Placement placeB = placement(random);
        a.follow(placeA);
        b.follow(placeB);
        double[] p = placeA.at.clone();
        double[] q = p;
        for (int i = 0; i < 20_000; i++) {
            q = nearest(b, placeB, p);
            p = nearest(a, placeA, q);
        }
        double distance = Math.hypot(Math.hypot(p[0] - q[0], p[1] - q[1]), p[2] - q[2]);

        double gap = Union.of(a).gapTo(b);
        if (a.roughGap(b) > Union.WIDE) {
            assertThat(gap).isLessThan(distance);
        } else {
            assertThat(gap).isEqualTo(distance, within(1e-4));
        }
    }

    private static Placement placement(SplittableRandom random) {
        Placement p = new Placement();
        p.set(
                random.nextDouble(-1, 1),
                random.nextDouble(-1, 1),
                random.nextDouble(-1, 1),
                new double[] {
                    random.nextDouble(-1, 1),
                    random.nextDouble(-1, 1),
                    random.nextDouble(-1, 1),
                    random.nextDouble(-1, 1)
                });
        return p;
    }

    private static double[] nearest(Part part, Placement place, double[] point) {
        double[] inside = new double[3];
        for (int axis = 0; axis < 3; axis++) {
            double x = place.inward(axis, point[0], point[1], point[2]);
            inside[axis] = Math.clamp(x, -part.half[axis], part.half[axis]);
        }
        double[] outside = new double[3];
        place.outward(inside[0], inside[1], inside[2], outside, 0);
        return outside;
    }

    @Test
    void theAxisOfASymmetricTopCirclesTheAngularMomentum() {
        // Goldstein, section 5.6: at the rate L / I about L, here along z.
        double transverse = 0.5;
        double tilt = 0.4;
        double rate = 3;
        double axial = 0.2;
        double[] spin = new double[3];
        double[] turn = {StrictMath.cos(tilt / 2), 0, StrictMath.sin(tilt / 2), 0};
        // L = (0, 0, transverse * rate): along the tilted axis L cos, across it L sin.
        double along = transverse * rate * StrictMath.cos(tilt) / axial;
        double across = rate * StrictMath.sin(tilt);
        spin[0] = along * StrictMath.sin(tilt) - across * StrictMath.cos(tilt);
        spin[2] = along * StrictMath.cos(tilt) + across * StrictMath.sin(tilt);
        FreeFlight top =
                new FreeFlight(
                        ZERO,
                        ZERO,
                        ZERO,
                        new double[] {transverse, transverse, axial},
                        turn,
                        spin,
                        2);

        double[] r = top.at(1.7).turn;

        assertThat(r[2]).isEqualTo(StrictMath.sin(tilt) * StrictMath.cos(rate * 1.7), within(1e-9));
        assertThat(r[5]).isEqualTo(StrictMath.sin(tilt) * StrictMath.sin(rate * 1.7), within(1e-9));
        assertThat(r[8]).isEqualTo(StrictMath.cos(tilt), within(1e-9));
    }

    private static FreeFlight moving(double x, double y, double vx, double ay) {
        return new FreeFlight(
                new double[] {x, y, 0},
                new double[] {vx, 0, 0},
                new double[] {0, ay, 0},
                ROUND,
                UPRIGHT,
                ZERO,
                2);
    }

    @Test
    void contactsAreFoundAtTheirInstants() {
        Encounter headOn =
                new Encounter(moving(-3, 0, 2, 0), ball(0.5), moving(0, 0, 0, 0), ball(0.5));
        assertThat(headOn.firstWithin(0, 0, 2)).isEqualTo(1, within(1e-14));
        assertThat(headOn.firstWithin(0.5, 0, 2)).isEqualTo(0.75, within(1e-14));

        Encounter falling =
                new Encounter(moving(0, 1.5, 1, -10), ball(0.5), at(0, 0, 0, Y_UP), new Ground(0));
        assertThat(falling.firstWithin(0, 0, 2)).isEqualTo(Math.sqrt(0.2), within(1e-14));
    }

    @Test
    void theSlightestGrazeIsSeen() {
        for (double depth : new double[] {1e-4, 1e-8, 1e-11}) {
            Encounter graze =
                    new Encounter(
                            moving(-2, 1 - depth, 2, 0), ball(0.5), moving(0, 0, 0, 0), ball(0.5));
            double half = Math.sqrt(depth * (2 - depth));
            assertThat(graze.firstWithin(0, 0, 2))
                    .isEqualTo(1 - half / 2, within(1e-15 / half + 1e-14));
        }
        Encounter miss =
                new Encounter(
                        moving(-2, 1 + 1e-11, 2, 0), ball(0.5), moving(0, 0, 0, 0), ball(0.5));
        assertThat(miss.firstWithin(0, 0, 2)).isInfinite();
        assertThat(miss.least()).isEqualTo(1e-11, within(1e-14));
    }

    /** A map of an inclined plane is that plane, within its edges. */
    @ParameterizedTest(name = "seed {0}")
    @MethodSource("seeds")
    void aMapOfAPlaneIsAsFarAsThePlane(long seed) {
        SplittableRandom random = new SplittableRandom(seed);
        double a = random.nextDouble(-1, 1);
        double b = random.nextDouble(-1, 1);
        double[][] heights = new double[40][40];
        for (int j = 0; j < 40; j++) {
            for (int i = 0; i < 40; i++) {
                heights[j][i] = 0.2 * (a * i + b * j);
            }
        }
        Terrain map = new Terrain(0.2, heights);
        Part part =
                switch ((int) seed % 3) {
                    case 0 -> new Part(0, 0, 0, random.nextDouble(0.5));
                    case 1 -> new Part(random.nextDouble(0.5), 0, 0, random.nextDouble(0.5));
                    default -> new Part(random.nextDouble(), random.nextDouble(0.5), 0.2, 0);
                };
        Placement place = placement(random);
        double steepness = Math.sqrt(1 + a * a + b * b);
        place.at[0] += 4;
        place.at[1] += 4;
        place.at[2] += a * place.at[0] + b * place.at[1] + random.nextDouble(2) * steepness;
        part.follow(place);
        map.follow(new Placement());

        double plane = Double.POSITIVE_INFINITY;
        for (int v = 0; v < part.vertices.length; v += 3) {
            double above = part.vertices[v + 2] - a * part.vertices[v] - b * part.vertices[v + 1];
            plane = Math.min(plane, above / steepness - part.radius);
        }
        if (map.gapTo(part) == Union.WIDE) {
            assertThat(plane).isGreaterThanOrEqualTo(Union.WIDE);
        } else if (plane > 0) {
            assertThat(map.gapTo(part)).isEqualTo(plane, within(1e-12));
        } else {
            assertThat(map.gapTo(part)).isLessThanOrEqualTo(1e-12);
        }
    }

    @Test
    void aRidgeOfAMapAndAValley() {
        // Along y = 0.5: up to 0.5 at x = 0.5 and down again.
        Terrain roof = new Terrain(0.5, new double[][] {{0, 0.5, 0}, {0, 0.5, 0}, {0, 0.5, 0}});
        roof.follow(new Placement());
        Part ball = new Part(0, 0, 0, 0.1);

        ball.follow(at(0.5, 0.4, 0.7, UPRIGHT).at(0));
        assertThat(roof.gapTo(ball)).isEqualTo(0.1, within(1e-15));
        ball.follow(at(-0.1, 0.4, 0.2, UPRIGHT).at(0));
        assertThat(roof.gapTo(ball)).isEqualTo(0.1, within(1e-15));
        ball.follow(at(0.1, 0.4, 0.3, UPRIGHT).at(0));
        assertThat(roof.gapTo(ball)).isEqualTo(0.2 / Math.sqrt(2) - 0.1, within(1e-15));
    }
}
