package org.auvsim.viz.drawing;

import org.auvsim.viz.camera.OrbitCamera;
import org.auvsim.viz.scene.Scene;
import org.auvsim.viz.scene.SeenObject;

import java.util.List;
import java.util.OptionalLong;

/** How a world is looked at that nobody has looked at before. */
public final class FirstLook {
    private FirstLook() {}

    /** All that moves is in the picture; the only object that can move is followed. */
    public static void take(Scene scene, ViewOptions options, OrbitCamera camera) {
        Framing.fit(scene, camera);
        options.follow(alone(scene));
    }

    /** The only object that can move, if there is one: it would leave the picture. */
    private static OptionalLong alone(Scene scene) {
        List<SeenObject> free =
                scene.objects().stream().filter(object -> !object.isFixed()).toList();
        return free.size() == 1 ? OptionalLong.of(free.getFirst().id()) : OptionalLong.empty();
    }
}
