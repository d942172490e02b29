package org.auvsim.core.effect;

import org.auvsim.core.entity.Domain;
import org.auvsim.core.math.Vec3;

/**
 * The law of an elastic line that pulls and never pushes: at a distance d beyond its length its
 * tension is max(0, k (d - length) + c d'), else 0.
 */
final class Line {
    private Line() {}

    /**
     * Refuses a line whose length (m) or damping c (N s/m) is below 0, or whose stiffness k (N/m)
     * is not above it.
     *
     * @param owner what sentences call it: "a mooring"
     */
    static void requireValid(String owner, double length, double stiffness, double damping) {
        Domain.atLeast0(owner, "length", length, "m");
        Domain.above0(owner, "stiffness", stiffness, "N/m");
        Domain.atLeast0(owner, "damping", damping, "N s/m");
    }

    /**
     * The force (N) on its near end; the far end gets the opposite.
     *
     * @param way from the near to the far end (m)
     * @param velocity of the far end relative to the near one (m/s)
     */
    static Vec3 pull(Vec3 way, Vec3 velocity, double length, double stiffness, double damping) {
        double distance = way.norm();
        if (distance <= length || distance == 0) {
            return Vec3.ZERO;
        }
        double lengthening = velocity.dot(way) / distance;
        double tension = stiffness * (distance - length) + damping * lengthening;
        return way.times(Math.max(0, tension) / distance);
    }
}
