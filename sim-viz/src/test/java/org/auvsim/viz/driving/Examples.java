package org.auvsim.viz.driving;

import org.auvsim.auvsml.document.DocumentException;
import org.auvsim.auvsml.document.ScenarioLoader;
import org.auvsim.core.entity.WorldObjectDefinition;

import java.nio.file.Path;

/** Vehicles of the repository's examples. */
final class Examples {
    private Examples() {}

    /** The first object of an example scenario. */
    static WorldObjectDefinition first(String scenario) throws DocumentException {
        Path file = Path.of("..", "examples", "scenarios", scenario);
        return ScenarioLoader.load(Examples.class.getClassLoader())
                .load(file)
                .worldObject()
                .getFirst();
    }
}
