package org.auvsim.viz.camera;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.auvsim.core.math.Vec3;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.util.SplittableRandom;

class OrbitCameraTest {
    private static final int WIDTH = 800;
    private static final int HEIGHT = 600;

    private final OrbitCamera camera = new OrbitCamera();
    private final double[] pixel = new double[3];

    private void project(double x, double y, double z) {
        camera.project(x, y, z, WIDTH, HEIGHT, pixel);
    }

    @Test
    void whatIsLookedAtIsInTheMiddle() {
        camera.aim(3, -4, 5, 7);
        project(3, -4, 5);
        assertThat(pixel).containsExactly(400, 300, 7);
    }

    @Test
    void fromAboveXIsRightAndYIsUp() {
        camera.aim(0, 0, 0, 10);
        StandardView.TOP.apply(camera);
        camera.perspective(false);
        double pixels = HEIGHT / camera.height();
        project(1, 0, 0);
        assertThat(pixel[0]).isCloseTo(400 + pixels, within(0.1));
        assertThat(pixel[1]).isCloseTo(300, within(0.1));
        project(0, 1, 0);
        assertThat(pixel[0]).isCloseTo(400, within(0.1));
        assertThat(pixel[1]).isCloseTo(300 - pixels, within(0.2));
    }

    @Test
    void fromTheSideZIsUp() {
        camera.aim(0, 0, 0, 10);
        StandardView.SIDE.apply(camera);
        project(0, 0, 1);
        assertThat(pixel[0]).isCloseTo(400, within(1e-9));
        assertThat(pixel[1]).isLessThan(300);
    }

    @Test
    void halfTheFieldOfViewReachesTheEdge() {
        camera.aim(0, 0, 0, 10);
        StandardView.SIDE.apply(camera);
        project(0, 0, 10 * Math.tan(Math.toRadians(22.5)));
        assertThat(pixel[1]).isCloseTo(0, within(1e-9));
    }

    @Test
    void whatIsBehindHasNoDepth() {
        camera.aim(0, 0, 0, 10);
        project(camera.position(0) * 2, camera.position(1) * 2, camera.position(2) * 2);
        assertThat(pixel[2]).isCloseTo(-10, within(1e-9));
    }

    @Test
    void panningMovesWhatWasInTheMiddleByThatPartOfThePicture() {
        camera.aim(1, 2, 3, 10);
        camera.pan(0.25, -0.5);
        project(1, 2, 3);
        assertThat(pixel[0]).isCloseTo(400 - 0.25 * HEIGHT, within(1e-9));
        assertThat(pixel[1]).isCloseTo(300 - 0.5 * HEIGHT, within(1e-9));
    }

    @ParameterizedTest(name = "seed {0}")
    @ValueSource(longs = {1, 2, 3, 4, 5})
    void aPinholeSeesTheSame(long seed) {
        SplittableRandom random = new SplittableRandom(seed);
        camera.aim(
                random.nextDouble(-9, 9), random.nextDouble(-9, 9), random.nextDouble(-9, 9), 12);
        camera.look(random.nextDouble(-3, 3), random.nextDouble(-1.4, 1.4));
        for (int i = 0; i < 20; i++) {
            Vec3 point =
                    camera.target()
                            .plus(
                                    new Vec3(
                                            random.nextDouble(-3, 3),
                                            random.nextDouble(-3, 3),
                                            random.nextDouble(-3, 3)));
            project(point.x(), point.y(), point.z());
            assertThat(new double[] {pixel[0], pixel[1]})
                    .containsExactly(pinhole(point), within(1e-6));
        }
    }

    /** By the ray from the eye through the picture's plane, its axes from cross products. */
    private double[] pinhole(Vec3 point) {
        Vec3 eye = new Vec3(camera.position(0), camera.position(1), camera.position(2));
        Vec3 ahead = camera.target().minus(eye).normalized();
        Vec3 right = ahead.cross(new Vec3(0, 0, 1)).normalized();
        Vec3 up = right.cross(ahead);
        Vec3 ray = point.minus(eye);
        double focal = HEIGHT / 2.0 / Math.tan(Math.toRadians(22.5));
        double depth = ray.dot(ahead);
        return new double[] {
            400 + focal * ray.dot(right) / depth, 300 - focal * ray.dot(up) / depth
        };
    }
}
