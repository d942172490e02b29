package org.auvsim.viz.driving;

import org.lwjgl.glfw.GLFW;
import org.lwjgl.glfw.GLFWGamepadState;

import java.util.Locale;
import java.util.Optional;
import java.util.function.Consumer;

/** The first gamepad that GLFW knows. Ask it always on the same thread. */
public final class GlfwGamepad implements Gamepad {
    private final GLFWGamepadState state = GLFWGamepadState.create();

    private GlfwGamepad() {}

    /**
     * Looks for gamepads from now on.
     *
     * @param tell hears why there can be none
     */
    public static Gamepad open(Consumer<String> tell) {
        if (System.getProperty("os.name", "").toLowerCase(Locale.ROOT).contains("mac")) {
            // GLFW may be called there on the first thread only, which is not the windows'.
            tell.accept("Gamepads are not supported on macOS.");
            return Optional::empty;
        }
        try {
            // Windows are AWT's, which speaks X11.
            GLFW.glfwInitHint(GLFW.GLFW_PLATFORM, platform());
            if (GLFW.glfwInit()) {
                return new GlfwGamepad();
            }
            tell.accept("There is no gamepad: GLFW does not start here.");
        } catch (LinkageError e) {
            tell.accept("There is no gamepad: GLFW is missing here (" + e.getMessage() + ").");
        }
        return Optional::empty;
    }

    private static int platform() {
        return GLFW.glfwPlatformSupported(GLFW.GLFW_PLATFORM_X11)
                ? GLFW.GLFW_PLATFORM_X11
                : GLFW.GLFW_ANY_PLATFORM;
    }

    @Override
    public Optional<Sticks> poll() {
        // What was plugged in meanwhile is found here.
        GLFW.glfwPollEvents();
        for (int i = GLFW.GLFW_JOYSTICK_1; i <= GLFW.GLFW_JOYSTICK_LAST; i++) {
            if (GLFW.glfwJoystickIsGamepad(i) && GLFW.glfwGetGamepadState(i, state)) {
                return Optional.of(
                        new Sticks(
                                state.axes(GLFW.GLFW_GAMEPAD_AXIS_LEFT_X),
                                state.axes(GLFW.GLFW_GAMEPAD_AXIS_LEFT_Y),
                                state.axes(GLFW.GLFW_GAMEPAD_AXIS_RIGHT_X),
                                state.axes(GLFW.GLFW_GAMEPAD_AXIS_RIGHT_Y),
                                pressed(GLFW.GLFW_GAMEPAD_AXIS_LEFT_TRIGGER),
                                pressed(GLFW.GLFW_GAMEPAD_AXIS_RIGHT_TRIGGER)));
            }
        }
        return Optional.empty();
    }

    private double pressed(int trigger) {
        return (state.axes(trigger) + 1) / 2;
    }
}
