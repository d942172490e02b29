package org.auvsim.diagnosis.cause;

import org.auvsim.core.actuator.Fin;
import org.auvsim.core.entity.Component;
import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.diagnosis.model.Variant;

import java.util.ArrayList;
import java.util.List;
import java.util.function.UnaryOperator;

/** Fins that do otherwise than they should. */
final class FinCauses {
    private static final double MOST_TAKEN = 0.95;

    /** A fin is not built in by more than this (rad) beside where it belongs. */
    private static final double MOST_OFF = 0.5;

    private FinCauses() {}

    static List<Cause> of(Setting s) {
        List<Cause> causes = new ArrayList<>();
        for (Fin fin : fins(s.body())) {
            causes.add(gain(fin.name()));
            causes.add(race(s, fin.name()));
            causes.add(offset(fin.name()));
        }
        return causes;
    }

    static List<Fin> fins(WorldObjectDefinition body) {
        return body.component().stream()
                .filter(Fin.class::isInstance)
                .map(Fin.class::cast)
                .toList();
    }

    private static Cause gain(String name) {
        return Change.of(
                        "fin_gain",
                        List.of(new Parameter("factor", "1", 0.1, -MOST_TAKEN, 100)),
                        (v, t) -> with(v, name, fin -> fin.sized(fin.area() * (1 + t[0]))))
                .toldAsFactors()
                .about(name);
    }

    /**
     * A stream that is faster than the water around, or slower: a propeller's, or the hull's wake.
     */
    private static Cause race(Setting s, String name) {
        double speed = s.path().speed();
        return Change.of(
                        "fin_race",
                        List.of(new Parameter("speed", "m/s", 0.1 * speed, -speed, 100 * speed)),
                        (v, t) -> with(v, name, fin -> fin.inRace(fin.race() + t[0])))
                .about(name);
    }

    /** A linkage or a servo whose zero is not where it is believed to be. */
    private static Cause offset(String name) {
        return Change.of(
                        "fin_offset",
                        List.of(new Parameter("angle", "rad", 0.02, -MOST_OFF, MOST_OFF)),
                        (v, t) -> with(v, name, fin -> fin.trimmed(t[0])))
                .about(name)
                .asGeneric();
    }

    /** The model with a fin changed. */
    private static Variant with(Variant v, String name, UnaryOperator<Fin> change) {
        List<Component> components = new ArrayList<>(v.body().component());
        components.replaceAll(
                c -> c instanceof Fin fin && fin.name().equals(name) ? change.apply(fin) : c);
        return v.with(b -> b.components(components));
    }
}
