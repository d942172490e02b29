package org.auvsim.auvsml.run;

import org.auvsim.core.description.Default;
import org.auvsim.core.description.Unit;
import org.auvsim.core.entity.Current;
import org.auvsim.core.entity.Effect;
import org.auvsim.core.entity.Field;

import java.util.List;

/**
 * What one run is known to have had that the scenario has not.
 *
 * @param mass beside the body's own, may be below 0
 * @param effect on the body, beside its own
 * @param field currents beside those of the scenario
 */
public record RunDifferences(
        @Unit("kg") @Default("0.0") double mass, List<Effect> effect, List<Field<?>> field) {
    /**
     * Checked differences.
     *
     * @throws IllegalArgumentException if a field is no current
     */
    public RunDifferences {
        effect = List.copyOf(effect);
        field = List.copyOf(field);
        for (Field<?> each : field) {
            if (!(each instanceof Current)) {
                throw new IllegalArgumentException(
                        "a run's own fields must be currents, but '%s' is none"
                                .formatted(each.name()));
            }
        }
    }

    /** The fields, each of which is one. */
    public List<Current> currents() {
        return field.stream().map(Current.class::cast).toList();
    }
}
