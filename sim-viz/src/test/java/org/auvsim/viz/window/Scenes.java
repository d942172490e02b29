package org.auvsim.viz.window;

import org.auvsim.auvsml.document.DocumentException;
import org.auvsim.auvsml.document.ScenarioLoader;
import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.core.volume.Sphere;
import org.auvsim.viz.scene.LiveClock;
import org.auvsim.viz.scene.Scene;
import org.auvsim.viz.scene.SeenObject;

import java.nio.file.Path;

/** Scenes to look at. */
final class Scenes {
    private Scenes() {}

    /** The objects of the repository's example of a name, and a buoy 9. */
    static Scene of(String example) throws DocumentException {
        Scene scene = withBuoy();
        Path file = Path.of("..", "examples", "scenarios", example);
        ScenarioLoader.load(Scenes.class.getClassLoader())
                .load(file)
                .worldObject()
                .forEach(d -> scene.add(SeenObject.of(d.id().orElse(100), d)));
        return scene;
    }

    /** A buoy 9 of 1 m and 20 kg at (5, 0, 0). */
    static Scene withBuoy() {
        Scene scene = new Scene(new LiveClock());
        scene.add(SeenObject.of(9, buoy()));
        scene.look(0, look -> {});
        return scene;
    }

    static WorldObjectDefinition buoy() {
        return WorldObjectDefinition.named("Buoy")
                .id(9)
                .mass(20)
                .volume(new Sphere(1))
                .position(5, 0, 0)
                .build();
    }

    /** A fixed ball of 1 m at the origin. */
    static WorldObjectDefinition rock() {
        return WorldObjectDefinition.named("Rock").fixed().volume(new Sphere(1)).build();
    }
}
