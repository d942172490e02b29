package org.auvsim.core.actuator;

import org.auvsim.core.description.Unit;
import org.auvsim.core.entity.Domain;

/**
 * What spins in a propulsor, about its direction: its angular momentum turns with the body (a
 * gyroscopic torque) and is taken from the body when it spins up.
 *
 * @param inertia about its axis, propeller, shaft and motor together (kg m^2)
 * @param speed at level 1 (rad/s), in proportion to the level; positive is right-handed about the
 *     direction
 */
public record Rotor(@Unit("kg m^2") double inertia, @Unit("rad/s") double speed) {
    /**
     * A checked rotor.
     *
     * @throws IllegalArgumentException if the inertia is negative, or a number is not finite
     */
    public Rotor {
        Domain.atLeast0("a rotor", "inertia", inertia, "kg m^2");
        Domain.finite("a rotor", "speed", speed, "rad/s");
    }

    /** Angular momentum (kg m^2/s) about its axis at a level. */
    double spin(double level) {
        return inertia * speed * level;
    }
}
