package org.auvsim.examples.scala;

import org.auvsim.auvsml.document.DocumentException;
import org.auvsim.auvsml.document.Scenario;
import org.auvsim.auvsml.document.ScenarioLoader;

import java.nio.file.Path;

/** The module's scenario. */
final class BungeeScenario {
    private BungeeScenario() {}

    static Scenario scenario() throws DocumentException {
        return ScenarioLoader.load(BungeeScenario.class.getClassLoader())
                .load(Path.of("bungee.xml"));
    }
}
