package org.auvsim.diagnosis.reading;

import org.auvsim.core.entity.Actuator;
import org.auvsim.core.entity.Behavior;
import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.core.math.Quat;

import java.util.ArrayList;
import java.util.List;

/** What of a measured body's model matters to its measurements. */
final class MeasuredBody {
    private final WorldObjectDefinition definition;
    private final CommandNames commands;

    MeasuredBody(WorldObjectDefinition definition) {
        this.definition = definition;
        this.commands = new CommandNames(definition);
    }

    String name() {
        return definition.name();
    }

    /** What it can be told. */
    CommandNames commands() {
        return commands;
    }

    /** That of the scenario, which tells angles that are not measured. */
    Quat usualOrientation() {
        return definition.orientation();
    }

    /** A sentence for each actuator that nothing tells what to do. */
    List<String> undirected(List<String> told) {
        List<String> sentences = new ArrayList<>();
        boolean actsByItself = definition.component().stream().anyMatch(Behavior.class::isInstance);
        for (Actuator actuator : commands.actuators()) {
            if (!told.contains(actuator.name()) && !actsByItself) {
                sentences.add(
                        "nothing tells '%s' what to do: it holds the scenario's %s"
                                .formatted(actuator.name(), actuator.command()));
            }
        }
        return sentences;
    }
}
