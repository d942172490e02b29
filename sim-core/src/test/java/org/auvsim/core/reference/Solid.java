package org.auvsim.core.reference;

import java.util.List;

/** A volume of the reference: how far it is from another one. */
sealed interface Solid permits Union, Ground, Terrain {
    /** Farthest that a point which turns with it is from its origin (m): 0 for a ball. */
    double swing();

    /** Smaller by {@code margin} (m) on all sides. */
    Solid eroded(double margin);

    /** Moves to a placement. */
    void follow(Placement body);

    /** The convex parts, where they are now. */
    List<Part> parts();

    /** Gap (m) to a convex part where both are now; 0 or less if they share a point. */
    double gapTo(Part part);
}
