package org.auvsim.core.volume;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.auvsim.core.math.Draws;
import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Distances of spheres, capsules and boxes against the slow way of finding them. */
class ConvexDistanceTest {
    private final PairQueries queries = PairQueries.standard();
    private final Separation found = new Separation();

    /** A volume of one of three kinds. */
    static Volume drawn(Draws draws, int kind) {
        return switch (kind) {
            case 0 -> new Sphere(draws.number(0.1, 1));
            case 1 -> new Capsule(draws.number(0.1, 1), draws.number(0.1, 3));
            default -> new Box(draws.vector(0.2, 2));
        };
    }

    private interface Check {
        void of(Volume a, Pose poseA, Volume b, Pose poseB);
    }

    private void everyPair(Draws draws, int times, double reach, Check check) {
        for (int i = 0; i < times; i++) {
            for (int a = 0; a < 3; a++) {
                for (int b = 0; b < 3; b++) {
                    check.of(
                            drawn(draws, a),
                            Pose.of(draws.vector(reach), draws.orientation()),
                            drawn(draws, b),
                            Pose.of(draws.vector(reach), draws.orientation()));
                }
            }
        }
    }

    @ParameterizedTest(name = "seed {0}")
    @ValueSource(longs = {1, 2, 3, 4, 5, 6, 7, 8})
    void distanceIsThatOfTheNearestFeatures(long seed) {
        everyPair(new Draws(seed), 100, 3, this::isTheLeast);
    }

    private void isTheLeast(Volume a, Pose poseA, Volume b, Pose poseB) {
        double expected = EnumeratedDistance.between(a, poseA, b, poseB);
        double distance = queries.distance(a, poseA, b, poseB, found);
        assertThat(distance).isEqualTo(found.distance);
        double cores = expected + radius(a) + radius(b);
        if (cores > 1e-14) {
            assertThat(distance).as("%s %s", a, b).isCloseTo(expected, within(1e-12));
        } else {
            assertThat(distance).as("%s %s", a, b).isLessThanOrEqualTo(expected + 1e-12);
        }
    }

    private static double radius(Volume volume) {
        return switch (volume) {
            case Sphere sphere -> sphere.radius();
            case Capsule capsule -> capsule.radius();
            default -> 0;
        };
    }

    @ParameterizedTest(name = "seed {0}")
    @ValueSource(longs = {1, 2, 3, 4, 5, 6, 7, 8})
    void faceToFaceAndEdgeToEdgeAreNoExceptions(long seed) {
        Draws draws = new Draws(seed);
        for (double tilt : new double[] {0, 1e-15, 1e-12, 1e-9, 1e-7, 1e-5, 1e-3}) {
            for (int i = 0; i < 10; i++) {
                for (int kind = 3; kind < 9; kind++) {
                    Pose first = aligned(draws, tilt);
                    Pose second = aligned(draws, tilt);
                    isTheLeast(halves(draws, kind % 3), first, halves(draws, kind / 3), second);
                }
            }
        }
    }

    /** Sizes and places on a lattice, so that faces and edges often lie in line. */
    private static Volume halves(Draws draws, int kind) {
        return switch (kind) {
            case 0 -> new Sphere(0.5);
            case 1 -> new Capsule(0.25, lattice(draws));
            default -> new Box(new Vec3(lattice(draws), lattice(draws), lattice(draws)));
        };
    }

    private static double lattice(Draws draws) {
        return Math.floor(draws.number(1, 4)) / 2;
    }

    private static Pose aligned(Draws draws, double tilt) {
        Quat turn = Quat.IDENTITY;
        for (int i = 0; i < 3; i++) {
            Vec3 axis = new Vec3(i == 0 ? 1 : 0, i == 1 ? 1 : 0, i == 2 ? 1 : 0);
            double quarters = Math.floor(draws.number(0, 8)) / 2;
            turn = Quat.ofAxisAngle(axis, quarters * Math.PI / 2).times(turn);
        }
        turn = Quat.ofAxisAngle(draws.direction(), tilt).times(turn).normalized();
        Vec3 place = new Vec3(lattice(draws), 2 * lattice(draws), 2 * lattice(draws));
        return Pose.of(place, turn);
    }

    @ParameterizedTest(name = "seed {0}")
    @ValueSource(longs = {1, 2, 3, 4, 5, 6, 7, 8})
    void aTinyGapIsAsExactAsALargeOne(long seed) {
        Draws draws = new Draws(seed);
        everyPair(
                draws,
                20,
                3,
                (a, poseA, b, poseB) -> {
                    double far = queries.distance(a, poseA, b, poseB, found);
                    for (double gap : new double[] {1e-3, 1e-6, 1e-9, 1e-12}) {
                        if (far > gap) {
                            Vec3 n = new Vec3(found.nx, found.ny, found.nz);
                            Vec3 nearer = poseA.position().minus(n.times(far - gap));
                            Pose moved = Pose.of(nearer, poseA.orientation());
                            Separation there = new Separation();
                            assertThat(queries.distance(a, moved, b, poseB, there))
                                    .as("%s %s", a, b)
                                    .isCloseTo(gap, within(2e-14));
                            assertThat(there.nx * n.x() + there.ny * n.y() + there.nz * n.z())
                                    .isPositive();
                        }
                    }
                });
    }

    @ParameterizedTest(name = "seed {0}")
    @ValueSource(longs = {1, 2, 3, 4, 5, 6, 7, 8})
    void movedApartByTheOverlapTheyJustTouch(long seed) {
        everyPair(
                new Draws(seed),
                100,
                0.7,
                (a, poseA, b, poseB) -> {
                    double distance = queries.distance(a, poseA, b, poseB, found);
                    if (distance < 0) {
                        Vec3 n = new Vec3(found.nx, found.ny, found.nz);
                        Vec3 out = poseA.position().minus(n.times(distance));
                        Pose moved = Pose.of(out, poseA.orientation());
                        assertThat(queries.distance(a, moved, b, poseB, found))
                                .as("%s %s", a, b)
                                .isCloseTo(0, within(1e-12));
                    }
                });
    }

    @ParameterizedTest(name = "seed {0}")
    @ValueSource(longs = {1, 2, 3, 4, 5, 6, 7, 8})
    void exchangedVolumesGiveTheSameToTheBit(long seed) {
        Separation other = new Separation();
        everyPair(
                new Draws(seed),
                100,
                2,
                (a, poseA, b, poseB) -> {
                    queries.distance(a, poseA, b, poseB, found);
                    queries.distance(b, poseB, a, poseA, other);
                    other.flip();
                    assertThat(numbers(other)).containsExactly(numbers(found));
                });
    }

    private static double[] numbers(Separation s) {
        return new double[] {s.distance, s.nx, s.ny, s.nz, s.px, s.py, s.pz};
    }

    @ParameterizedTest(name = "seed {0}")
    @ValueSource(longs = {1, 2, 3, 4, 5, 6, 7, 8})
    void movingAndTurningTheWorldChangesNoDistance(long seed) {
        Draws draws = new Draws(seed);
        everyPair(
                draws,
                50,
                2,
                (a, poseA, b, poseB) -> {
                    double before = queries.distance(a, poseA, b, poseB, found);
                    Quat turn = draws.orientation();
                    Vec3 shift = draws.vector(5);
                    double after =
                            queries.distance(
                                    a,
                                    moved(poseA, turn, shift),
                                    b,
                                    moved(poseB, turn, shift),
                                    found);
                    assertThat(after).as("%s %s", a, b).isCloseTo(before, within(2e-14));
                });
    }

    private static Pose moved(Pose pose, Quat turn, Vec3 shift) {
        return Pose.of(
                turn.rotate(pose.position()).plus(shift),
                turn.times(pose.orientation()).normalized());
    }

    @ParameterizedTest(name = "seed {0}")
    @ValueSource(longs = {1, 2, 3, 4, 5, 6, 7, 8})
    void thePlaceIsBetweenTheSurfaces(long seed) {
        everyPair(
                new Draws(seed),
                50,
                3,
                (a, poseA, b, poseB) -> {
                    double distance = queries.distance(a, poseA, b, poseB, found);
                    if (distance > 0) {
                        Pose place = Pose.of(new Vec3(found.px, found.py, found.pz), Quat.IDENTITY);
                        Sphere point = new Sphere(Double.MIN_NORMAL);
                        double half = distance / 2;
                        assertThat(EnumeratedDistance.between(point, place, a, poseA))
                                .isCloseTo(half, within(1e-9));
                        assertThat(EnumeratedDistance.between(point, place, b, poseB))
                                .isCloseTo(half, within(1e-9));
                    }
                });
    }
}
