package org.auvsim.viz.window;

import org.auvsim.core.math.Vec3;
import org.auvsim.viz.camera.OrbitCamera;
import org.auvsim.viz.scene.Scene;
import org.auvsim.viz.scene.SeenObject;

import java.util.Optional;
import java.util.OptionalLong;

/** Finds the object that somebody clicked at. */
final class Picking {
    /** A click this near (pixels) to a small object means it. */
    private static final double NEAR = 12;

    private Picking() {}

    /**
     * The object at a pixel: of those whose round is hit the one whose middle is nearest to the
     * click for its size. Walls and the like are hit at their middle alone: their rounds hold
     * everything else.
     */
    static OptionalLong at(Scene scene, OrbitCamera camera, int x, int y, int width, int height) {
        double[] place = new double[3];
        double best = 1;
        OptionalLong found = OptionalLong.empty();
        for (SeenObject object : scene.objects()) {
            Optional<Vec3> at = scene.motion(object.id()).map(m -> m.position());
            double radius = radius(object);
            if (at.isEmpty() || Double.isInfinite(radius)) {
                continue;
            }
            Vec3 p = at.get();
            camera.project(p.x(), p.y(), p.z(), width, height, place);
            if (place[2] <= 0) {
                continue;
            }
            double pixels = object.isFixed() ? 0 : radius * camera.pixelsPerMetre(place[2], height);
            double size = Math.max(NEAR, pixels);
            double miss = Math.hypot(place[0] - x, place[1] - y) / size;
            if (miss <= best) {
                best = miss;
                found = OptionalLong.of(object.id());
            }
        }
        return found;
    }

    /** Radius (m) of the smallest ball that holds an object; infinite without end. */
    static double radius(SeenObject object) {
        return object.definition().map(d -> d.volume().boundingRadius()).orElse(1.0);
    }
}
