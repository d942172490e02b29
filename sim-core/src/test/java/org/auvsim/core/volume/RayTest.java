package org.auvsim.core.volume;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.auvsim.core.math.Mat3;
import org.auvsim.core.math.Numbers;
import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import java.util.stream.LongStream;

/** Where rays meet volumes, against known distances and against small steps along the ray. */
class RayTest {
    private static final double RANGE = 12;
    private static final double STEP = 4e-3;

    static LongStream seeds() {
        return LongStream.rangeClosed(1, 12);
    }

    private static Vec3 ahead(Volume volume, double x, double y, double z) {
        double distance = volume.distance(new Ray(new Vec3(x, y, z), new Vec3(1, 0, 0), RANGE));
        return new Vec3(distance, y, z);
    }

    @Test
    void knownDistances() {
        assertThat(ahead(new Sphere(1), -5, 0, 0).x()).isEqualTo(4);
        assertThat(ahead(new Sphere(1), -5, 0.6, 0).x()).isCloseTo(4.2, within(1e-15));
        assertThat(ahead(new Box(new Vec3(2, 4, 6)), -5, 1.9, -2.9).x()).isEqualTo(4);
        assertThat(ahead(new Capsule(1, 2), -5, 0, 0).x()).isEqualTo(3);
        assertThat(ahead(new Capsule(1, 2), -5, 0.6, 0).x()).isCloseTo(3.2, within(1e-15));
        Ray down = new Ray(new Vec3(0.5, 0, 5), new Vec3(0, 0, -1), RANGE);
        assertThat(new Capsule(1, 2).distance(down)).isEqualTo(4);
        assertThat(new HalfSpace().distance(down)).isEqualTo(5);
    }

    @Test
    void whatIsBehindBesideOrTooFarIsMissed() {
        assertThat(ahead(new Sphere(1), 5, 0, 0).x()).isEqualTo(Ray.MISS);
        assertThat(ahead(new Sphere(1), -5, 1.01, 0).x()).isEqualTo(Ray.MISS);
        assertThat(ahead(new Sphere(1), -13.5, 0, 0).x()).isEqualTo(Ray.MISS);
        assertThat(ahead(new Box(new Vec3(1, 1, 1)), 5, 0, 0).x()).isEqualTo(Ray.MISS);
        assertThat(ahead(new Box(new Vec3(1, 1, 1)), -13.5, 0, 0).x()).isEqualTo(Ray.MISS);
        assertThat(ahead(new Capsule(1, 2), 5, 0, 0).x()).isEqualTo(Ray.MISS);
        assertThat(ahead(new HalfSpace(), 0, 0, 1).x()).isEqualTo(Ray.MISS);
    }

    @Test
    void fromInsideItIsNoWay() {
        for (Volume volume :
                List.of(
                        new Sphere(1),
                        new Box(new Vec3(1, 1, 1)),
                        new Capsule(0.5, 1),
                        new HalfSpace())) {
            assertThat(ahead(volume, -0.1, 0.1, -0.1).x()).as("%s", volume).isZero();
        }
    }

    @ParameterizedTest(name = "seed {0}")
    @MethodSource("seeds")
    void smallStepsFindTheSame(long seed) {
        SplittableRandom random = new SplittableRandom(seed);
        for (Volume volume : volumes(random)) {
            for (int i = 0; i < 15; i++) {
                Ray ray = new Ray(point(random, 4), direction(random), RANGE);
                check(volume, ray);
            }
        }
    }

    /** The first step inside is the answer, but for what is thinner than a step. */
    private static void check(Volume volume, Ray ray) {
        double found = volume.distance(ray);
        double limit = Math.min(found, RANGE);
        for (double t = 0; t < limit - 1e-9; t += STEP) {
            assertThat(volume.contains(ray.at(t)))
                    .as("%s at %s m of %s, found at %s m", volume, t, ray, found)
                    .isFalse();
        }
        if (found < Ray.MISS) {
            boolean touches = false;
            for (double e = -1e-9; e <= 1e-9; e += 1e-10) {
                touches |= volume.contains(ray.at(found + e));
            }
            assertThat(touches).as("%s at %s m of %s", volume, found, ray).isTrue();
        }
    }

    private static List<Volume> volumes(SplittableRandom random) {
        Volume box = new Box(new Vec3(size(random), size(random), size(random)));
        Volume capsule = new Capsule(size(random), size(random));
        Volume ball = new Sphere(size(random));
        Compound compound =
                new Compound(
                        List.of(
                                new Part(box, point(random, 2), turn(random)),
                                new Part(capsule, point(random, 2), turn(random)),
                                new Part(ball, point(random, 2), Quat.IDENTITY)));
        return List.of(box, capsule, ball, compound, new HalfSpace(), map(random));
    }

    private static HeightMap map(SplittableRandom random) {
        List<HeightMap.Row> rows = new ArrayList<>();
        for (int j = 0; j < 5; j++) {
            rows.add(new HeightMap.Row(Numbers.of(random.doubles(4, -2, 1).toArray())));
        }
        return new HeightMap(0.7, rows);
    }

    private static double size(SplittableRandom random) {
        return random.nextDouble(0.2, 2);
    }

    private static Vec3 point(SplittableRandom random, double far) {
        return new Vec3(
                random.nextDouble(-far, far),
                random.nextDouble(-far, far),
                random.nextDouble(-far, far));
    }

    private static Vec3 direction(SplittableRandom random) {
        return point(random, 1).normalized();
    }

    private static Quat turn(SplittableRandom random) {
        return Quat.ofAxisAngle(direction(random), random.nextDouble(-3, 3));
    }

    @Test
    void aRayAlongTheGridAndDownItsLinesMeetsTheSurface() {
        HeightMap map =
                new HeightMap(
                        1,
                        List.of(
                                new HeightMap.Row(Numbers.of(0, 0, 3)),
                                new HeightMap.Row(Numbers.of(0, 1, 3)),
                                new HeightMap.Row(Numbers.of(0, 0, 3))));

        Ray along = new Ray(new Vec3(-4, 1, 2), new Vec3(1, 0, 0), RANGE);
        assertThat(map.distance(along)).isCloseTo(5.5, within(1e-14));
        Ray down = new Ray(new Vec3(1, 1, 4), new Vec3(0, 0, -1), RANGE);
        assertThat(map.distance(down)).isCloseTo(3, within(1e-14));
        Ray over = new Ray(new Vec3(-4, 1, 3.1), new Vec3(1, 0, 0), RANGE);
        assertThat(map.distance(over)).isEqualTo(Ray.MISS);
    }

    /** A volume of a user's own, which knows no more than what it contains. */
    private record Egg() implements Volume {
        @Override
        public double boundingRadius() {
            return 2;
        }

        @Override
        public Mat3 inertia(double mass) {
            return Mat3.diagonal(mass, mass, mass);
        }

        @Override
        public boolean contains(Vec3 p) {
            return p.x() * p.x() / 4 + p.y() * p.y() + p.z() * p.z() <= 1;
        }
    }

    @Test
    void aVolumeThatOnlyKnowsWhatItContainsIsFoundToo() {
        assertThat(ahead(new Egg(), -5, 0, 0).x()).isCloseTo(3, within(1e-9));
        assertThat(ahead(new Egg(), -5, 0.6, 0).x()).isCloseTo(5 - 1.6, within(1e-9));
        assertThat(ahead(new Egg(), -5, 1.2, 0).x()).isEqualTo(Ray.MISS);
        assertThat(ahead(new Egg(), 5, 0, 0).x()).isEqualTo(Ray.MISS);
        assertThat(ahead(new Egg(), 0, 0, 0).x()).isZero();
    }
}
