package org.auvsim.core.entity;

import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.volume.Volume;

import java.util.Optional;

/**
 * An entity that others can run into (thesis, section 6.3): a rigid body, or something that moves
 * by a rule of its own, such as the front of a wave.
 *
 * <p>For a rigid body place and volume are those of its world's present time.
 */
public interface Collidable extends Entity {
    /** Position (m, world) of the volume's origin at {@code time} (s). */
    Vec3 positionAt(double time);

    /** Orientation at {@code time} (s), body to world. */
    default Quat orientationAt(double time) {
        return Quat.IDENTITY;
    }

    /** The space that it takes up at {@code time} (s). */
    Volume volumeAt(double time);

    /**
     * How fast (m/s) any point of its surface moves at most between two times (s). With a bound no
     * contact is missed; infinity, which means unknown, leaves the search to sampled instants.
     */
    default double fastestSurface(double from, double to) {
        return Double.POSITIVE_INFINITY;
    }

    /** Whether a meeting with {@code other} is a collision; false for what it has met already. */
    default boolean meets(Collidable other) {
        return true;
    }

    /** What it does in a collision; empty: what the world does by default. */
    Optional<CollisionResponse> response();
}
