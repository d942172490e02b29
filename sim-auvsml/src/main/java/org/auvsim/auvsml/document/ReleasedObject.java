package org.auvsim.auvsml.document;

import org.auvsim.core.description.Default;
import org.auvsim.core.description.Unit;
import org.auvsim.core.entity.Domain;

/**
 * What becomes of a world object whose client lets go of it, or goes.
 *
 * @param forces of the object
 * @param deceleration with which it brakes
 * @param angularDeceleration with which its turning is slowed down
 */
public record ReleasedObject(
        @Default("keep") ReleasedForces forces,
        @Unit("m/s^2") @Default("0.5") double deceleration,
        @Unit("rad/s^2") @Default("0.5") double angularDeceleration) {
    /** All goes on as it is: whether a client is connected then changes nothing by itself. */
    public static final ReleasedObject UNCHANGED =
            new ReleasedObject(ReleasedForces.KEEP, 0.5, 0.5);

    /**
     * A checked choice.
     *
     * @throws IllegalArgumentException if a deceleration is not above 0
     */
    public ReleasedObject {
        Domain.above0("a released object", "deceleration", deceleration, "m/s^2");
        Domain.above0("a released object", "angular deceleration", angularDeceleration, "rad/s^2");
    }
}
