package org.auvsim.diagnosis.run;

import org.auvsim.core.entity.Current;
import org.auvsim.core.entity.Effect;

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
}
