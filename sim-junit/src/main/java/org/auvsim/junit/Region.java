package org.auvsim.junit;

import org.auvsim.core.math.Vec3;

import java.util.Optional;

/** Where a body may be; a user's own may be anything that can be asked of a place and a time. */
@FunctionalInterface
public interface Region {
    /** What is wrong with a place (m, world) at a world time (s); empty if it is allowed. */
    Optional<Breach> breach(double time, Vec3 position);

    /**
     * How a body is outside.
     *
     * @param verb what it does, as "leaves the box"
     * @param actual where it is, as "z = -3.2 m"
     * @param allowed where it may be, as "-3 to 0 m"
     */
    record Breach(String verb, String actual, String allowed) {}

    /**
     * A box along the world's axes, its faces included; a corner may be infinite.
     *
     * @param low its least x, y and z (m, world)
     * @param high its greatest ones
     * @throws IllegalArgumentException if nothing is inside
     */
    static Region box(Vec3 low, Vec3 high) {
        return new BoxRegion(low, high);
    }

    /**
     * What is at most {@code distance} (m) from a point (m, world).
     *
     * @throws IllegalArgumentException if the distance is negative or not finite
     */
    static Region around(Vec3 centre, double distance) {
        return new BallRegion(centre, distance);
    }

    /**
     * What is at most {@code distance} (m) from where another body is at the same time; nowhere
     * while that one is not in the world.
     *
     * @throws IllegalArgumentException if the distance is negative or not finite
     */
    static Region around(Trajectory other, double distance) {
        return new EscortRegion(other, distance);
    }
}
