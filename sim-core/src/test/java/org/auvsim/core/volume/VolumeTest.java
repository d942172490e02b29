package org.auvsim.core.volume;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.auvsim.core.math.Near.assertNear;

import org.auvsim.core.math.Draws;
import org.auvsim.core.math.Mat3;
import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

import java.util.stream.IntStream;
import java.util.stream.Stream;

class VolumeTest {
    private static final int CELLS = 80;

    static Stream<Volume> volumes() {
        return Stream.of(new Sphere(0.7), new Box(new Vec3(2, 1, 0.5)), new Capsule(0.4, 1.5));
    }

    /** The mean of r^2 I - r r^T over the cells of a grid whose middles the volume contains. */
    @ParameterizedTest
    @MethodSource("volumes")
    void inertiaIsTheIntegralOverTheVolume(Volume volume) {
        double[] middles = middles(volume.boundingRadius());
        double[] sum = new double[6];
        int inside = 0;
        for (double x : middles) {
            for (double y : middles) {
                for (double z : middles) {
                    if (volume.contains(new Vec3(x, y, z))) {
                        inside++;
                        sum[0] += x * x;
                        sum[1] += y * y;
                        sum[2] += z * z;
                        sum[3] -= x * y;
                        sum[4] -= x * z;
                        sum[5] -= y * z;
                    }
                }
            }
        }
        double k = 3.0 / inside;
        double xx = k * (sum[1] + sum[2]);
        double yy = k * (sum[0] + sum[2]);
        double zz = k * (sum[0] + sum[1]);
        double xy = k * sum[3];
        double xz = k * sum[4];
        double yz = k * sum[5];
        assertNear(volume.inertia(3), new Mat3(xx, xy, xz, xy, yy, yz, xz, yz, zz), 0.01);
    }

    private static double[] middles(double radius) {
        double cell = 2 * radius / CELLS;
        return IntStream.range(0, CELLS).mapToDouble(i -> (i + 0.5) * cell - radius).toArray();
    }

    @ParameterizedTest
    @MethodSource("volumes")
    void theBoundingRadiusHoldsAllAndNotMore(Volume volume) {
        Draws draws = new Draws(5);
        double farthest = 0;
        for (int i = 0; i < 100_000; i++) {
            Vec3 point = draws.vector(1.2 * volume.boundingRadius());
            if (volume.contains(point)) {
                farthest = Math.max(farthest, point.norm());
            }
        }
        assertThat(farthest).isBetween(0.95 * volume.boundingRadius(), volume.boundingRadius());
    }

    @Test
    void theSurfaceBelongsToTheVolume() {
        assertThat(new Sphere(5).contains(new Vec3(3, 0, 4))).isTrue();
        assertThat(new Sphere(5).contains(new Vec3(3, 0, Math.nextUp(4.0)))).isFalse();
        Box box = new Box(new Vec3(2, 4, 6));
        assertThat(box.contains(new Vec3(-1, 2, -3))).isTrue();
        assertThat(box.contains(new Vec3(Math.nextUp(1.0), 0, 0))).isFalse();
        assertThat(box.contains(new Vec3(0, -Math.nextUp(2.0), 0))).isFalse();
        assertThat(box.contains(new Vec3(0, 0, Math.nextUp(3.0)))).isFalse();
    }

    @ParameterizedTest
    @ValueSource(doubles = {0, -1, Double.NaN, Double.POSITIVE_INFINITY})
    void aRadiusThatIsNoneIsRefused(double radius) {
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new Sphere(radius))
                .withMessage(
                        "a sphere's radius must be above 0 m and finite, but is " + radius + " m");
    }

    @ParameterizedTest
    @ValueSource(doubles = {0, -1, Double.NaN, Double.POSITIVE_INFINITY})
    void anEdgeThatIsNoneIsRefused(double edge) {
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new Box(new Vec3(1, edge, 1)))
                .withMessage(
                        "a box's edges must be above 0 m and finite, but are (1.0, %s, 1.0) m"
                                .formatted(edge));
    }

    @ParameterizedTest
    @ValueSource(doubles = {0, -1, Double.NaN, Double.POSITIVE_INFINITY})
    void aCapsuleOfNoSizeIsRefused(double size) {
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new Capsule(size, 1))
                .withMessage(
                        "a capsule's radius must be above 0 m and finite, but is " + size + " m");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new Capsule(1, size))
                .withMessage(
                        "a capsule's length must be above 0 m and finite, but is " + size + " m");
    }

    @Test
    void aHalfSpaceHasNoMassAndNoEnd() {
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new HalfSpace().inertia(1))
                .withMessage(
                        "a half-space has no mass: make the object fixed and leave its mass out");
        assertThat(new HalfSpace().isBounded()).isFalse();
        assertThat(new HalfSpace().contains(new Vec3(1e9, 0, 0))).isTrue();
        assertThat(new HalfSpace().contains(new Vec3(1e9, 0, Double.MIN_VALUE))).isFalse();
        double[] bounds = new double[6];
        new HalfSpace().bounds(Pose.of(new Vec3(1, 2, 3), Quat.IDENTITY), bounds, 0);
        double endless = Double.POSITIVE_INFINITY;
        assertThat(bounds).containsExactly(-endless, -endless, -endless, endless, endless, 3);
    }
}
