package org.auvsim.viz.window;

import org.auvsim.core.actuator.Fin;
import org.auvsim.core.actuator.Propulsor;
import org.auvsim.viz.scene.SeenObject;

/** Objects by what they can do. */
enum Kind {
    /** They have propulsors or fins. */
    VEHICLE("Vehicles"),
    /** They move as they are pushed. */
    BODY("Free"),
    /** They never move. */
    FIXED("Fixed"),
    /** What they are made of is not known. */
    UNKNOWN("Unknown");

    private final String title;

    Kind(String title) {
        this.title = title;
    }

    String title() {
        return title;
    }

    static Kind of(SeenObject object) {
        if (object.definition().isEmpty()) {
            return UNKNOWN;
        }
        if (object.isFixed()) {
            return FIXED;
        }
        boolean isDriven =
                object.definition().get().component().stream()
                        .anyMatch(c -> c instanceof Propulsor || c instanceof Fin);
        return isDriven ? VEHICLE : BODY;
    }
}
