package org.auvsim.viz.window;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.auvsim.core.math.Vec3;
import org.auvsim.viz.camera.OrbitCamera;
import org.auvsim.viz.drawing.ViewOptions;
import org.junit.jupiter.api.Test;

import java.awt.Component;
import java.awt.event.InputEvent;
import java.awt.event.MouseEvent;
import java.awt.event.MouseWheelEvent;
import java.util.OptionalLong;

class ScreenMouseTest {
    private static final int HEIGHT = 600;

    private final OrbitCamera camera = new OrbitCamera();
    private final ViewOptions options = new ViewOptions();
    private final FakeScreen screen = new FakeScreen();
    private final Component canvas = screen.component();

    ScreenMouseTest() {
        canvas.setSize(800, HEIGHT);
        camera.look(0, 0);
        camera.aim(0, 0, 0, 20);
        ScreenMouse.attach(new Desk(new FakeRecording(Scenes.withBuoy()), camera, screen, options));
    }

    private void drag(int modifiers, int button, int right, int down) {
        send(MouseEvent.MOUSE_PRESSED, modifiers, 100, 100, button);
        send(MouseEvent.MOUSE_DRAGGED, modifiers, 100 + right, 100 + down, MouseEvent.NOBUTTON);
        send(MouseEvent.MOUSE_RELEASED, 0, 100 + right, 100 + down, button);
    }

    private void send(int what, int modifiers, int x, int y, int button) {
        canvas.dispatchEvent(new MouseEvent(canvas, what, 0, modifiers, x, y, 1, false, button));
    }

    private double height() {
        return Math.toDegrees(Math.asin(-camera.forward(2)));
    }

    @Test
    void aLeftDragGoesAroundTheTarget() {
        drag(InputEvent.BUTTON1_DOWN_MASK, MouseEvent.BUTTON1, 0, 50);
        assertThat(height()).isCloseTo(20, within(1e-9));
        assertThat(camera.target()).isEqualTo(Vec3.ZERO);
        drag(InputEvent.BUTTON1_DOWN_MASK, MouseEvent.BUTTON1, 50, -50);
        assertThat(height()).isCloseTo(0, within(1e-9));
        // From ahead to 20 degrees to the left of it.
        assertThat(camera.forward(1)).isCloseTo(Math.sin(Math.toRadians(20)), within(1e-9));
    }

    @Test
    void aMiddleDragTakesThePictureAlongAndFollowsNothing() {
        options.follow(OptionalLong.of(9));
        drag(InputEvent.BUTTON2_DOWN_MASK, MouseEvent.BUTTON2, 0, HEIGHT / 2);
        assertThat(camera.target().z()).isCloseTo(camera.height() / 2, within(1e-9));
        assertThat(options.followed()).isEmpty();
    }

    @Test
    void aLeftDragWithShiftIsAMiddleDrag() {
        drag(
                InputEvent.BUTTON1_DOWN_MASK | InputEvent.SHIFT_DOWN_MASK,
                MouseEvent.BUTTON1,
                0,
                HEIGHT / 2);
        assertThat(camera.target().z()).isCloseTo(camera.height() / 2, within(1e-9));
        assertThat(height()).isCloseTo(0, within(1e-9));
    }

    @Test
    void theWheelGoesNearerAndAway() {
        wheel(-2);
        assertThat(camera.distance()).isLessThan(20);
        wheel(2);
        assertThat(camera.distance()).isCloseTo(20, within(1e-9));
    }

    private void wheel(int notches) {
        canvas.dispatchEvent(
                new MouseWheelEvent(
                        canvas,
                        MouseEvent.MOUSE_WHEEL,
                        0,
                        0,
                        100,
                        100,
                        0,
                        false,
                        MouseWheelEvent.WHEEL_UNIT_SCROLL,
                        1,
                        notches));
    }
}
