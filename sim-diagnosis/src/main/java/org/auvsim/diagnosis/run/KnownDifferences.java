package org.auvsim.diagnosis.run;

import org.auvsim.core.entity.Current;
import org.auvsim.core.entity.Effect;
import org.auvsim.core.entity.Inertia;
import org.auvsim.core.entity.MassProperties;
import org.auvsim.core.entity.WorldObjectDefinition;

import java.util.List;

/**
 * What one run had that the scenario has not, and that is known: a ballast, another day's current.
 *
 * @param mass beside the body's own (kg), may be below 0
 * @param effects beside the body's own
 * @param currents beside those of the scenario
 */
public record KnownDifferences(double mass, List<Effect> effects, List<Current> currents) {
    /** As the scenario has it. */
    public static final KnownDifferences NONE = new KnownDifferences(0, List.of(), List.of());

    /** The lists cannot be changed. */
    public KnownDifferences {
        effects = List.copyOf(effects);
        currents = List.copyOf(currents);
    }

    /**
     * A body that has them. Its moments of inertia stay as they are, also where they are those of
     * its volume: variants of it that state them would else be far from the others.
     */
    public WorldObjectDefinition.Builder on(WorldObjectDefinition body) {
        WorldObjectDefinition.Builder other = body.toBuilder();
        effects.forEach(other::effect);
        if (mass != 0) {
            MassProperties alone = body.massProperties().orElseThrow();
            other.mass(alone.mass() + mass).inertia(Inertia.of(alone.inertia()));
        }
        return other;
    }
}
