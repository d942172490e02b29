package org.auvsim.viz.window;

import org.auvsim.core.math.Vec3;
import org.auvsim.viz.camera.OrbitCamera;
import org.auvsim.viz.scene.Scene;
import org.auvsim.viz.scene.SeenObject;

import java.util.Optional;

/** Where the camera is put at a word. */
final class Views {
    private static final double MARGIN = 1.15;

    /** What the camera stays away from at least (m). */
    private static final double LEAST = 1;

    private Views() {}

    static void top(OrbitCamera camera) {
        camera.look(Math.toRadians(-90), Math.toRadians(90));
    }

    /** From where x points to: y is to the right. */
    static void side(OrbitCamera camera) {
        camera.look(0, 0);
    }

    /** From where y comes from: x is to the right. */
    static void front(OrbitCamera camera) {
        camera.look(Math.toRadians(-90), 0);
    }

    static void isometric(OrbitCamera camera) {
        camera.look(Math.toRadians(-135), Math.atan(Math.sqrt(0.5)));
    }

    /** Sees all that moves, or if nothing does all that has an end. */
    static void fit(OrbitCamera camera, Scene scene) {
        if (!fit(camera, scene, true)) {
            fit(camera, scene, false);
        }
    }

    private static boolean fit(OrbitCamera camera, Scene scene, boolean onlyMoving) {
        double[] least = {1e300, 1e300, 1e300};
        double[] most = {-1e300, -1e300, -1e300};
        for (SeenObject object : scene.objects()) {
            double radius = Picking.radius(object);
            Optional<Vec3> at = scene.motion(object.id()).map(m -> m.position());
            if (at.isEmpty() || Double.isInfinite(radius) || (onlyMoving && object.isFixed())) {
                continue;
            }
            double[] p = {at.get().x(), at.get().y(), at.get().z()};
            for (int axis = 0; axis < 3; axis++) {
                least[axis] = Math.min(least[axis], p[axis] - radius);
                most[axis] = Math.max(most[axis], p[axis] + radius);
            }
        }
        if (least[0] > most[0]) {
            return false;
        }
        double[] half = new double[3];
        for (int axis = 0; axis < 3; axis++) {
            half[axis] = (most[axis] - least[axis]) / 2;
        }
        double radius = Math.sqrt(half[0] * half[0] + half[1] * half[1] + half[2] * half[2]);
        double away = MARGIN * radius / Math.sin(OrbitCamera.FIELD_OF_VIEW / 2);
        camera.aim(
                least[0] + half[0], least[1] + half[1], least[2] + half[2], Math.max(away, LEAST));
        return true;
    }
}
