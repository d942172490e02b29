package org.auvsim.examples.renderer;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.volume.Pose;
import org.auvsim.viz.Renderers;
import org.auvsim.viz.camera.OrbitCamera;
import org.auvsim.viz.camera.StandardView;
import org.auvsim.viz.drawing.Brush;
import org.auvsim.viz.drawing.Painter;
import org.auvsim.viz.drawing.Renderer;
import org.auvsim.viz.drawing.ScreenException;
import org.junit.jupiter.api.Test;

import java.awt.image.BufferedImage;

class SketchTest implements Painter {
    private static final int RED = 0xffe0504a;
    private static final int BLUE = 0xff4b83e8;

    private final OrbitCamera camera = new OrbitCamera();

    /** Found by its name, as with --renderer. */
    private static Renderer sketch() throws ScreenException {
        return Renderers.named("sketch", SketchTest.class.getClassLoader());
    }

    @Override
    public void paint(Brush brush, long nanos) {
        brush.ball(Pose.of(new Vec3(1, 0, 0), Quat.IDENTITY), 2, RED);
        Quat left = Quat.ofAxisAngle(new Vec3(0, 0, 1), Math.PI / 2);
        brush.tube(Pose.of(new Vec3(-3, 0, 0), left), 2, 0.1, BLUE);
        brush.line(-4, -3, 0, 4, -3, 0, BLUE);
    }

    @Override
    public OrbitCamera camera() {
        return camera;
    }

    @Override
    public int background() {
        return 0xff10202c;
    }

    private boolean isNear(BufferedImage picture, double x, double y, int colour) {
        double[] at = new double[3];
        camera.project(x, y, 0, picture.getWidth(), picture.getHeight(), at);
        for (int i = 0; i < 9; i++) {
            if (picture.getRGB((int) at[0] + i % 3 - 1, (int) at[1] + i / 3 - 1) == colour) {
                return true;
            }
        }
        return false;
    }

    @Test
    void outlinesAreWhereTheCameraProjectsThem() throws ScreenException {
        camera.aim(0, 0, 0, 12);
        StandardView.TOP.apply(camera);
        camera.perspective(false);
        BufferedImage picture = sketch().picture(this, 640, 480);
        assertThat(isNear(picture, 3, 0, RED)).isTrue();
        assertThat(isNear(picture, 1, 2, RED)).isTrue();
        assertThat(isNear(picture, 1, 0, RED)).isFalse();
        assertThat(isNear(picture, -2, -3, BLUE)).isTrue();
        assertThat(isNear(picture, -3, 0.9, BLUE)).isTrue();
        assertThat(isNear(picture, -3, 1.2, BLUE)).isFalse();
        assertThat(isNear(picture, -2, 3, background())).isTrue();
    }

    @Test
    void thereIsNoWindowOfIt() {
        assertThatThrownBy(() -> sketch().screen(this)).hasMessageContaining("--picture");
    }
}
