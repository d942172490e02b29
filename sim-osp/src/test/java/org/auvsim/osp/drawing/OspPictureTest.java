// SPDX-License-Identifier: GPL-2.0-or-later
package org.auvsim.osp.drawing;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.volume.Pose;
import org.auvsim.core.volume.Sphere;
import org.auvsim.viz.camera.OrbitCamera;
import org.auvsim.viz.camera.StandardView;
import org.auvsim.viz.drawing.Brush;
import org.auvsim.viz.drawing.Layer;
import org.auvsim.viz.drawing.Painter;
import org.auvsim.viz.drawing.SceneDrawing;
import org.auvsim.viz.drawing.ViewOptions;
import org.auvsim.viz.scene.LiveClock;
import org.auvsim.viz.scene.Movement;
import org.auvsim.viz.scene.Scene;
import org.auvsim.viz.scene.SeenObject;
import org.auvsim.viz.source.Playback;
import org.auvsim.viz.source.Source;
import org.auvsim.viz.source.Steering;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

import java.awt.image.BufferedImage;
import java.util.Optional;
import java.util.function.Consumer;

/** Pictures of known things, which are where {@link OrbitCamera#project} says. */
@Timeout(120)
class OspPictureTest {
    private static final int WIDTH = 640;
    private static final int HEIGHT = 480;
    private static final int DARK = 0x10202c;
    private static final int RED = 0xffe0504a;
    private static final int BLUE = 0xff4b83e8;
    private static final int YELLOW = 0xffe6c84f;
    private static final int GREY = 0xff808080;

    private final OrbitCamera camera = new OrbitCamera();

    private BufferedImage picture(Consumer<Brush> what) {
        return picture(what, WIDTH, HEIGHT);
    }

    private BufferedImage picture(Consumer<Brush> what, int width, int height) {
        return new OspRenderer().picture(painter(what), width, height);
    }

    private Painter painter(Consumer<Brush> what) {
        return new Painter() {
            @Override
            public void paint(Brush brush, long nanos) {
                what.accept(brush);
            }

            @Override
            public OrbitCamera camera() {
                return camera;
            }

            @Override
            public int background() {
                return 0xff000000 | DARK;
            }
        };
    }

    private static Pose at(double x, double y, double z) {
        return Pose.of(new Vec3(x, y, z), Quat.IDENTITY);
    }

    private double[] pixel(double x, double y, double z) {
        double[] at = new double[3];
        camera.project(x, y, z, WIDTH, HEIGHT, at);
        return at;
    }

    private int colour(BufferedImage picture, double x, double y, double z) {
        double[] pixel = pixel(x, y, z);
        return picture.getRGB((int) Math.round(pixel[0]), (int) Math.round(pixel[1])) & 0xffffff;
    }

    /** The most blue above, at or below the pixel of a place. */
    private int bluest(BufferedImage picture, double x, double y, double z) {
        double[] pixel = pixel(x, y, z);
        int bluest = 0;
        for (int dy = -1; dy <= 1; dy++) {
            int seen = picture.getRGB((int) pixel[0], (int) pixel[1] + dy);
            bluest = Math.max(bluest, seen & 0xff);
        }
        return bluest;
    }

    /** Whether it is a colour in some light: its parts are in that colour's proportions. */
    private static boolean isLit(int seen, int colour) {
        double light = part(seen, colour, 16) + part(seen, colour, 8) + part(seen, colour, 0);
        for (int shift = 0; shift <= 16; shift += 8) {
            double expected = (colour >> shift & 0xff) * light / 3;
            if (Math.abs((seen >> shift & 0xff) - expected) > 6) {
                return false;
            }
        }
        return light / 3 > 0.4;
    }

    private static double part(int seen, int colour, int shift) {
        return (double) (seen >> shift & 0xff) / (colour >> shift & 0xff);
    }

    /** The middle of the pixels that are no background. */
    private static double[] middle(BufferedImage picture) {
        double[] sum = new double[3];
        for (int y = 0; y < picture.getHeight(); y++) {
            for (int x = 0; x < picture.getWidth(); x++) {
                if ((picture.getRGB(x, y) & 0xffffff) != DARK) {
                    sum[0] += x + 0.5;
                    sum[1] += y + 0.5;
                    sum[2]++;
                }
            }
        }
        return new double[] {sum[0] / sum[2], sum[1] / sum[2]};
    }

    @ParameterizedTest(
            name = "azimuth {0}°, elevation {1}°, from {2} m, perspective {3}, {4} x {5}")
    @CsvSource({
        "-125, 25, 12, true, 640, 480",
        "-125, 25, 12, false, 640, 480",
        "40, -60, 30, true, 480, 640",
        "40, -60, 30, false, 480, 640",
        "-90, 90, 9, true, 801, 303",
        "0, 0, 2000, true, 640, 480",
        "170, 10, 0.05, false, 640, 480",
    })
    void placesAreWhereTheCameraProjectsThem(
            double azimuth,
            double elevation,
            double distance,
            boolean perspective,
            int width,
            int height) {
        camera.aim(5e5, -3e5, -40, distance);
        camera.look(Math.toRadians(azimuth), Math.toRadians(elevation));
        camera.perspective(perspective);
        double[] at = new double[3];
        for (int i = 0; i < 9; i++) {
            double right = (i % 3 - 1) * 0.16 * distance;
            double up = (i / 3 - 1) * 0.11 * distance;
            double ahead = ((i + i / 3) % 3 - 1) * 0.2 * distance;
            double[] p = new double[3];
            for (int axis = 0; axis < 3; axis++) {
                p[axis] =
                        camera.target(axis)
                                + right * camera.right(axis)
                                + up * camera.up(axis)
                                + ahead * camera.forward(axis);
            }
            BufferedImage picture =
                    picture(
                            b -> b.ball(at(p[0], p[1], p[2]), 0.004 * distance, RED),
                            width,
                            height);
            camera.project(p[0], p[1], p[2], width, height, at);
            double[] seen = middle(picture);
            assertThat(Math.hypot(seen[0] - at[0], seen[1] - at[1])).isLessThan(1.5);
        }
    }

    private static void known(Brush brush) {
        brush.ball(at(-3, 0, 0), 0.5, RED);
        brush.ball(at(0, 0, 0), 0.5, BLUE);
        brush.box(at(0, 3, 0), 1, 1, 1, YELLOW);
        brush.ball(at(-2, -2, 0), 0.5, (RED & 0xffffff) | 0x60000000);
    }

    @ParameterizedTest
    @ValueSource(booleans = {true, false})
    void ballsABoxAndAGhostAreWhereTheyAre(boolean perspective) {
        camera.aim(0, 0, 0, 12);
        StandardView.TOP.apply(camera);
        camera.perspective(perspective);
        BufferedImage picture = picture(OspPictureTest::known);
        assertThat(isLit(colour(picture, -3, 0, 0), RED)).isTrue();
        assertThat(isLit(colour(picture, -3, 0.44, 0), RED)).isTrue();
        assertThat(colour(picture, -3, 0.55, 0)).isEqualTo(DARK);
        assertThat(isLit(colour(picture, 0, 0, 0), BLUE)).isTrue();
        assertThat(isLit(colour(picture, 0.45, 3.45, 0.5), YELLOW)).isTrue();
        assertThat(colour(picture, 0.56, 3.45, 0.5)).isEqualTo(DARK);
        int ghost = colour(picture, -2, -2, 0);
        int solid = colour(picture, -3, 0, 0);
        assertThat(ghost >> 16).isBetween((DARK >> 16) + 10, (solid >> 16) - 10);
        assertThat(colour(picture, -1.5, 0, 0)).isEqualTo(DARK);
        assertThat(picture.getWidth()).isEqualTo(WIDTH);
        assertThat(picture.getHeight()).isEqualTo(HEIGHT);
    }

    /** A scene by itself, that nobody steers. */
    private record Shown(Scene scene) implements Source {
        @Override
        public void bring(long nanos) {}

        @Override
        public String status() {
            return "";
        }

        @Override
        public Optional<Steering> steering() {
            return Optional.empty();
        }

        @Override
        public Optional<Playback> playback() {
            return Optional.empty();
        }

        @Override
        public void close() {}
    }

    @Test
    void aProjectedStateIsAGhostThatTheGhostsLayerShows() {
        camera.aim(0, 0, 0, 12);
        StandardView.TOP.apply(camera);
        Scene scene = new Scene(new LiveClock());
        scene.add(
                SeenObject.of(
                        1,
                        WorldObjectDefinition.named("Red Ball")
                                .mass(2)
                                .volume(new Sphere(0.5))
                                .position(-3, 0, 0)
                                .build()));
        Vec3 there = new Vec3(-2, -2, 0);
        scene.project(1, new Movement(0.1, there, Quat.IDENTITY, Vec3.ZERO, Vec3.ZERO));
        ViewOptions options = new ViewOptions();
        for (Layer layer : Layer.values()) {
            options.show(layer, layer == Layer.GHOSTS);
        }
        SceneDrawing drawing = new SceneDrawing(new Shown(scene), options, camera);
        BufferedImage picture = new OspRenderer().picture(drawing, WIDTH, HEIGHT);
        int solid = colour(picture, -3, 0, 0);
        assertThat(isLit(solid, RED)).isTrue();
        assertThat(colour(picture, -2, -2, 0) >> 16)
                .isBetween((DARK >> 16) + 10, (solid >> 16) - 10);
        options.show(Layer.GHOSTS, false);
        BufferedImage without = new OspRenderer().picture(drawing, WIDTH, HEIGHT);
        assertThat(colour(without, -2, -2, 0)).isEqualTo(DARK);
        assertThat(colour(without, -3, 0, 0)).isEqualTo(solid);
    }

    @Test
    void aPlateHidesWhatIsBelowAndNotWhatStandsOnIt() {
        camera.aim(0, 0, 0, 12);
        camera.look(0.3, Math.toRadians(15));
        BufferedImage picture =
                picture(
                        brush -> {
                            brush.ball(at(0, 0, 0.2), 0.2, RED);
                            brush.ball(at(0, 2, -0.5), 0.2, BLUE);
                            brush.box(at(0, 0, 0), 60, 60, 0, GREY);
                            brush.line(-5, -2, 0, 5, -2, 0, BLUE);
                        });
        assertThat(isLit(colour(picture, 0, 0, 0.2), RED)).isTrue();
        assertThat(isLit(colour(picture, 0, 2, -0.5), GREY)).isTrue();
        assertThat(bluest(picture, 0, -2, 0)).isGreaterThan(0xa0);
    }

    @Test
    void waterTintsWhatIsInItAndNotWhatIsAbove() {
        camera.aim(0, 0, 0, 12);
        camera.look(0.3, Math.toRadians(30));
        Consumer<Brush> balls =
                brush -> {
                    brush.ball(at(0, -1, 0.6), 0.4, RED);
                    brush.ball(at(0, 1, -0.6), 0.4, RED);
                };
        BufferedImage dry = picture(balls);
        BufferedImage wet = picture(balls.andThen(b -> b.box(at(0, 0, 0), 60, 60, 0, 0x402a7fb0)));
        assertThat(colour(wet, 0, -1, 0.6)).isEqualTo(colour(dry, 0, -1, 0.6));
        assertThat(colour(wet, 0, 1, -0.6) >> 16).isLessThan((colour(dry, 0, 1, -0.6) >> 16) - 10);
    }

    @Test
    void whatIsBehindTheCameraIsNotSeen() {
        camera.aim(0, 0, 0, 5);
        StandardView.FRONT.apply(camera);
        BufferedImage picture =
                picture(
                        brush -> {
                            brush.ball(at(9, 0, 0), 1, RED);
                            brush.line(8, 0, 0, 12, 1, 1, RED);
                            brush.label(9, 0, 0, "behind", RED);
                        });
        assertThat(middle(picture)).containsOnly(Double.NaN);
    }

    @Test
    void aScreenPaintsAndCounts() throws Exception {
        camera.aim(0, 0, 0, 12);
        StandardView.TOP.apply(camera);
        try (OspScreen screen = new OspScreen(painter(OspPictureTest::known))) {
            screen.component().setSize(WIDTH, HEIGHT);
            screen.start().get();
            BufferedImage picture = screen.picture().get();
            assertThat(isLit(colour(picture, 0, 0, 0), BLUE)).isTrue();
            while (screen.frameRate() == 0) {
                screen.picture().get();
            }
            assertThat(screen.frameRate()).isBetween(0.1, 40.0);
            assertThat(screen.component().getMouseListeners()).isEmpty();
        }
    }
}
