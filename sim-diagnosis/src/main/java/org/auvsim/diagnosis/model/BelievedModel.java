package org.auvsim.diagnosis.model;

import org.auvsim.auvsml.document.Scenario;
import org.auvsim.core.entity.WorldObjectDefinition;

import java.util.List;

/**
 * The model as it is believed: a scenario, and which of its bodies was measured.
 *
 * @param scenario a whole world
 * @param body the name of the body
 */
public record BelievedModel(Scenario scenario, String body) {
    /**
     * A checked model.
     *
     * @throws IllegalArgumentException if the scenario has no such body, or it cannot move
     */
    public BelievedModel {
        if (definition(scenario, body).fixed()) {
            throw new IllegalArgumentException(
                    "'%s' is fixed in the scenario; a body that moves is needed".formatted(body));
        }
    }

    private static WorldObjectDefinition definition(Scenario scenario, String body) {
        return scenario.worldObject().stream()
                .filter(object -> object.name().equals(body))
                .findFirst()
                .orElseThrow(
                        () ->
                                new IllegalArgumentException(
                                        "the scenario has no world object '%s'; it has %s"
                                                .formatted(
                                                        body,
                                                        scenario.worldObject().stream()
                                                                .map(WorldObjectDefinition::name)
                                                                .toList())));
    }

    /** The body as it is believed. */
    public Variant variant() {
        return new Variant(definition(scenario, body), List.of(), Sensing.EXACT);
    }
}
