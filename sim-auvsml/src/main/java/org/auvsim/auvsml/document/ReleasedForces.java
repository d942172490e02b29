package org.auvsim.auvsml.document;

import java.util.Locale;

/** What becomes of the forces on a world object that nobody controls any more. */
public enum ReleasedForces {
    /** They go on as they are. */
    KEEP,
    /** Its named forces are those of the scenario again, and its propulsors stand still. */
    REMOVE,
    /** The same, and a brake brings it to rest and holds it until somebody takes it. */
    BRAKE;

    /** Its name in a scenario, as {@code keep}. */
    @Override
    public String toString() {
        return name().toLowerCase(Locale.ROOT);
    }
}
