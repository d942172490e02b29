package org.auvsim.core.entity;

import org.auvsim.core.description.Default;
import org.auvsim.core.description.Unit;
import org.auvsim.core.math.Vec3;

/**
 * A propulsion device: pushes its object with {@code level * maximumThrust}, at a place and in a
 * direction that are fixed to the body.
 *
 * @param maximumThrust thrust (N) at level 1
 * @param level from -1 (full astern) to 1 (full ahead)
 * @param position where it pushes (m, body coordinates)
 * @param direction where it pushes to at a positive level (body axes; any length above 0)
 */
public record Propulsor(
        String name,
        @Unit("N") double maximumThrust,
        @Default("0.0") double level,
        @Unit("m") @Default("0 0 0") Vec3 position,
        @Default("1 0 0") Vec3 direction)
        implements Component {
    /**
     * A checked propulsor, its direction normalised.
     *
     * @throws IllegalArgumentException if the thrust is negative or not finite, the level outside
     *     [-1, 1], or the direction the zero vector
     */
    public Propulsor {
        if (!(maximumThrust >= 0) || Double.isInfinite(maximumThrust)) {
            throw new IllegalArgumentException(
                    "maximum thrust of propulsor '"
                            + name
                            + "' must be 0 N or more, but is "
                            + maximumThrust
                            + " N");
        }
        if (!(level >= -1 && level <= 1)) {
            throw new IllegalArgumentException(
                    "the level of propulsor '" + name + "' must be -1 to 1, but is " + level);
        }
        if (Math.abs(direction.dot(direction) - 1) > 1e-15) {
            direction = direction.normalized();
        }
    }

    /** The same propulsor at another level, -1 to 1. */
    public Propulsor withLevel(double level) {
        return new Propulsor(name, maximumThrust, level, position, direction);
    }

    /** The force (N, body axes) that it exerts. */
    public Vec3 thrust() {
        return direction.times(level * maximumThrust);
    }
}
