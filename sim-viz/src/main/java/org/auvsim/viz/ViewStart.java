package org.auvsim.viz;

import org.auvsim.viz.camera.OrbitCamera;
import org.auvsim.viz.camera.StandardView;
import org.auvsim.viz.drawing.FirstLook;
import org.auvsim.viz.drawing.ScreenException;
import org.auvsim.viz.drawing.ViewOptions;
import org.auvsim.viz.scene.Scene;
import org.auvsim.viz.scene.SeenObject;

import java.util.List;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.stream.Collectors;

/**
 * How a view begins.
 *
 * @param dark whether light stands before dark
 * @param from the side from which the scene is seen
 * @param follow the object that the camera goes with, by its name or id; by default the only one
 *     that can move
 */
public record ViewStart(boolean dark, StandardView from, Optional<String> follow) {
    /** So many times its own size is the camera away from what it follows. */
    private static final double AWAY = 8;

    private static final int MOST_NAMED = 20;

    /**
     * Lets options and camera begin so.
     *
     * @throws ScreenException if there is no object to follow of that name
     */
    void apply(Scene scene, ViewOptions options, OrbitCamera camera) throws ScreenException {
        options.dark(dark);
        from.apply(camera);
        FirstLook.take(scene, options, camera);
        if (follow.isPresent()) {
            SeenObject object = named(scene, follow.get());
            options.follow(OptionalLong.of(object.id()));
            options.select(OptionalLong.of(object.id()));
            double radius = object.definition().map(d -> d.volume().boundingRadius()).orElse(1.0);
            scene.motion(object.id())
                    .ifPresent(
                            m ->
                                    camera.aim(
                                            m.position().x(),
                                            m.position().y(),
                                            m.position().z(),
                                            AWAY * radius));
        }
    }

    private static SeenObject named(Scene scene, String name) throws ScreenException {
        for (SeenObject object : scene.objects()) {
            if (object.name().equals(name) || Long.toString(object.id()).equals(name)) {
                return object;
            }
        }
        throw new ScreenException(
                "There is no object '%s' to follow; there %s."
                        .formatted(name, those(scene.objects())));
    }

    /** As {@code is REMUS 100}, {@code are Red, Blue}. */
    private static String those(List<SeenObject> objects) {
        String names =
                objects.stream()
                        .limit(MOST_NAMED)
                        .map(SeenObject::name)
                        .collect(Collectors.joining(", "));
        return switch (objects.size()) {
            case 0 -> "are none";
            case 1 -> "is " + names;
            default -> "are " + names + (objects.size() > MOST_NAMED ? " and others" : "");
        };
    }
}
