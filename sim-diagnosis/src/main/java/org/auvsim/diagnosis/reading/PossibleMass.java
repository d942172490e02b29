package org.auvsim.diagnosis.reading;

import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.diagnosis.model.BelievedModel;

import java.util.Optional;

/** Whether a body has a mass that matter may have. */
final class PossibleMass {
    /** Osmium (kg/m^3; CRC Handbook of Chemistry and Physics). */
    private static final double OSMIUM = 22590;

    private PossibleMass() {}

    /** That the mass of the model's body may be told in grams; a sphere holds all of its volume. */
    static Optional<String> notice(BelievedModel model) {
        WorldObjectDefinition body = model.variant().body();
        double mass = body.mass().orElseThrow();
        double radius = body.volume().boundingRadius();
        double most = OSMIUM * 4 / 3 * Math.PI * radius * radius * radius;
        return radius > 0 && mass > most
                ? Optional.of(
                        "the scenario's '%s' has a mass of %s kg, but a sphere of any metal that holds its volume would have no more than %s kg: is its mass in g, or its volume too small? Both are told in kg and m"
                                .formatted(
                                        body.name(),
                                        Figures.shown(mass, 3),
                                        Figures.shown(most, 3)))
                : Optional.empty();
    }
}
