package org.auvsim.viz.window;

import org.auvsim.viz.camera.OrbitCamera;
import org.auvsim.viz.drawing.FirstLook;
import org.auvsim.viz.drawing.ViewOptions;
import org.auvsim.viz.scene.Scene;

/** Looks at a world that has taken the place of another one as at the first. */
final class NewWorld {
    private final Scene scene;
    private final ViewOptions options;
    private final OrbitCamera camera;
    private long seen;

    NewWorld(Scene scene, ViewOptions options, OrbitCamera camera) {
        this.scene = scene;
        this.options = options;
        this.camera = camera;
        seen = scene.worlds();
    }

    void refresh() {
        long now = scene.worlds();
        if (now != seen) {
            seen = now;
            FirstLook.take(scene, options, camera);
        }
    }
}
