package org.auvsim.diagnosis.model;

import org.auvsim.core.entity.Current;
import org.auvsim.core.entity.WorldObjectDefinition;

import java.util.ArrayList;
import java.util.List;
import java.util.function.UnaryOperator;

/**
 * The model of the measured body, as it is believed or otherwise. What differs is stated by what a
 * scenario has, too, so that every variant can be written as one.
 *
 * @param body with its mass, effects and components
 * @param currents of the water that it moves in, beside those of the model's world
 * @param sensing what measuring does to its motion
 */
public record Variant(WorldObjectDefinition body, List<Current> currents, Sensing sensing) {
    /** The lists cannot be changed. */
    public Variant {
        currents = List.copyOf(currents);
    }

    /** Whether another one moves alike, however it is measured. */
    public boolean movesAs(Variant other) {
        return body.equals(other.body) && currents.equals(other.currents);
    }

    /** The same with another body. */
    public Variant with(UnaryOperator<WorldObjectDefinition.Builder> change) {
        return new Variant(change.apply(body.toBuilder()).build(), currents, sensing);
    }

    /** The same in one more current. */
    public Variant in(Current current) {
        List<Current> more = new ArrayList<>(currents);
        more.add(current);
        return new Variant(body, more, sensing);
    }

    /** The same measured otherwise. */
    public Variant sensed(UnaryOperator<Sensing> change) {
        return new Variant(body, currents, change.apply(sensing));
    }
}
