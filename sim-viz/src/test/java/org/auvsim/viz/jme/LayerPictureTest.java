package org.auvsim.viz.jme;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.sensor.Dvl;
import org.auvsim.core.sensor.RangeSonar;
import org.auvsim.core.sensor.Sampling;
import org.auvsim.core.sensor.ScalarErrors;
import org.auvsim.core.sensor.Sensor;
import org.auvsim.core.sensor.VectorErrors;
import org.auvsim.core.volume.Sphere;
import org.auvsim.viz.camera.OrbitCamera;
import org.auvsim.viz.camera.StandardView;
import org.auvsim.viz.drawing.Layer;
import org.auvsim.viz.drawing.SceneDrawing;
import org.auvsim.viz.drawing.ViewOptions;
import org.auvsim.viz.scene.LiveClock;
import org.auvsim.viz.scene.Movement;
import org.auvsim.viz.scene.Scene;
import org.auvsim.viz.scene.SeenObject;
import org.auvsim.viz.source.SceneAlone;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

import java.awt.image.BufferedImage;

/** Lines and arrows around a red ball of a fifth of a metre, seen from above, a layer at a time. */
@Tag("display")
@Timeout(120)
class LayerPictureTest {
    private static final int WIDTH = 640;
    private static final int HEIGHT = 480;
    private static final int BACKGROUND = 0x10202c;
    private static final int RED = 0xe0504a;
    private static final int TURQUOISE = 0x38c7c0;
    private static final int VIOLET = 0xb58df0;
    private static final int GRID = 0x35505f;
    private static final Sampling OFTEN = new Sampling(1, 0, 0, 0);

    private final Scene scene = new Scene(new LiveClock());
    private final OrbitCamera camera = new OrbitCamera();

    @BeforeEach
    void look() {
        camera.aim(0, 0, 0, 12);
        StandardView.TOP.apply(camera);
    }

    private static WorldObjectDefinition.Builder ball() {
        return WorldObjectDefinition.named("Red").mass(2).volume(new Sphere(0.2));
    }

    private BufferedImage picture(Layer only) throws Exception {
        ViewOptions options = new ViewOptions();
        for (Layer layer : Layer.values()) {
            options.show(layer, layer == only);
        }
        SceneDrawing drawing = new SceneDrawing(new SceneAlone(scene), options, camera);
        return new JmeRenderer().picture(drawing, WIDTH, HEIGHT);
    }

    private double[] pixel(double x, double y, double z) {
        double[] at = new double[3];
        camera.project(x, y, z, WIDTH, HEIGHT, at);
        return at;
    }

    /** Whether a thin thing of a colour is at a place, to a pixel. */
    private boolean isAt(BufferedImage picture, int colour, double x, double y, double z) {
        double[] at = pixel(x, y, z);
        for (int dx = -1; dx <= 1; dx++) {
            for (int dy = -1; dy <= 1; dy++) {
                double[] beside = {at[0] + dx, at[1] + dy};
                if (Colours.rgb(picture, beside) == colour
                        || (colour != GRID && Colours.hasHue(picture, beside, colour))) {
                    return true;
                }
            }
        }
        return false;
    }

    private int seen(BufferedImage picture, double x, double y) {
        return Colours.rgb(picture, pixel(x, y, 0));
    }

    @Test
    void aTrailIsWhereTheObjectWas() throws Exception {
        scene.add(SeenObject.of(1, ball().build()));
        for (int t = 0; t <= 4; t++) {
            // Along x, then along y.
            Vec3 place = new Vec3(Math.min(t, 2), Math.max(t - 2, 0), 0);
            scene.move(1, new Movement(t, place, Quat.IDENTITY, Vec3.ZERO, Vec3.ZERO));
        }
        scene.jumpTo(4);
        BufferedImage picture = picture(Layer.TRAILS);
        assertThat(isAt(picture, RED, 0.5, 0, 0)).isTrue();
        assertThat(isAt(picture, RED, 2, 1.5, 0)).isTrue();
        assertThat(seen(picture, 1, 1)).isEqualTo(BACKGROUND);
        assertThat(seen(picture, -0.5, 0)).isEqualTo(BACKGROUND);
        assertThat(isAt(picture(Layer.AXES), RED, 2, 1.5, 0)).isFalse();
    }

    @Test
    void aVelocityReachesToWhereTheObjectWouldBeInASecond() throws Exception {
        scene.add(SeenObject.of(1, ball().velocity(0, 3, 0).build()));
        BufferedImage picture = picture(Layer.VELOCITIES);
        assertThat(isAt(picture, TURQUOISE, 0, 1.5, 0)).isTrue();
        assertThat(isAt(picture, TURQUOISE, 0, 2.9, 0)).isTrue();
        assertThat(seen(picture, 0, 3.1)).isEqualTo(BACKGROUND);
        assertThat(seen(picture, 0, -0.5)).isEqualTo(BACKGROUND);
    }

    private void sensing(Sensor sensor) {
        scene.add(SeenObject.of(1, ball().component(sensor).build()));
    }

    @Test
    void aSonarsFanReachesAsFarAsTheSonar() throws Exception {
        sensing(
                new RangeSonar(
                        "Sonar",
                        Vec3.ZERO,
                        Quat.IDENTITY,
                        5,
                        Math.PI / 2,
                        0,
                        4,
                        ScalarErrors.NONE,
                        OFTEN));
        BufferedImage picture = picture(Layer.SENSORS);
        assertThat(isAt(picture, VIOLET, 1.5, 1.5, 0)).isTrue();
        assertThat(isAt(picture, VIOLET, 1.5, -1.5, 0)).isTrue();
        assertThat(isAt(picture, VIOLET, 4, 0, 0)).isTrue();
        assertThat(seen(picture, 2, 0)).isEqualTo(BACKGROUND);
        assertThat(seen(picture, -1.5, 1.5)).isEqualTo(BACKGROUND);
    }

    @Test
    void aVelocityLogsBeamsGoDown() throws Exception {
        sensing(
                new Dvl(
                        "Log",
                        Vec3.ZERO,
                        Quat.IDENTITY,
                        Math.PI / 6,
                        5,
                        1,
                        VectorErrors.NONE,
                        ScalarErrors.NONE,
                        OFTEN));
        BufferedImage picture = picture(Layer.SENSORS);
        double wide = 2.5 * Math.sqrt(0.5);
        double down = -5 * Math.cos(Math.PI / 6);
        assertThat(isAt(picture, VIOLET, wide / 2, wide / 2, down / 2)).isTrue();
        assertThat(isAt(picture, VIOLET, -wide / 2, wide / 2, down / 2)).isTrue();
        assertThat(isAt(picture, VIOLET, 2.5, 0, down)).isTrue();
        assertThat(seen(picture, 1, 0)).isEqualTo(BACKGROUND);
    }

    @Test
    void theGridHasALineEachMetre() throws Exception {
        BufferedImage picture = picture(Layer.GRID);
        assertThat(isAt(picture, GRID, 2, 0.5, 0)).isTrue();
        assertThat(isAt(picture, GRID, -1.5, 3, 0)).isTrue();
        assertThat(seen(picture, 2.5, 0.5)).isEqualTo(BACKGROUND);
        assertThat(seen(picture(Layer.AXES), 2.5, 3)).isEqualTo(BACKGROUND);
    }
}
