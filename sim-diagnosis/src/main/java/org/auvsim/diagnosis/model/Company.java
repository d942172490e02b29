package org.auvsim.diagnosis.model;

import org.auvsim.auvsml.document.Scenario;
import org.auvsim.core.entity.CoupledEffect;
import org.auvsim.core.entity.WorldObjectDefinition;

import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;

/**
 * The other objects of a scenario. A diagnosis moves the measured body alone, among those that are
 * fixed: how others move in a run nobody has measured.
 */
record Company(Scenario scenario, WorldObjectDefinition body) {
    /** Those that move and may run into the body, or it into them. */
    List<WorldObjectDefinition> movers() {
        return others().filter(other -> !other.fixed() && meet(other, body)).toList();
    }

    /** Fixed ones that the body may touch, or is tied to. */
    List<WorldObjectDefinition> fixed() {
        return others().filter(WorldObjectDefinition::fixed)
                .filter(other -> meet(other, body) || isTied(body, other))
                .toList();
    }

    /** One that moves, too, and is tied to the body, without which that would move otherwise. */
    Optional<WorldObjectDefinition> tied() {
        return others().filter(other -> !other.fixed())
                .filter(other -> isTied(body, other) || isTied(other, body))
                .findFirst();
    }

    private Stream<WorldObjectDefinition> others() {
        return scenario.worldObject().stream().filter(other -> !other.name().equals(body.name()));
    }

    private static boolean isTied(WorldObjectDefinition one, WorldObjectDefinition to) {
        return one.effect().stream()
                .flatMap(
                        effect ->
                                effect instanceof CoupledEffect tie ? Stream.of(tie) : Stream.of())
                .anyMatch(
                        tie -> to.id().isPresent() && tie.partners().contains(to.id().getAsLong()));
    }

    /** Whether neither ignores the other. */
    static boolean meet(WorldObjectDefinition one, WorldObjectDefinition other) {
        return !isIgnored(one, other) && !isIgnored(other, one);
    }

    private static boolean isIgnored(WorldObjectDefinition one, WorldObjectDefinition by) {
        return by.ignores().stream().anyMatch(ignored -> ignored.layer() == one.layer());
    }
}
