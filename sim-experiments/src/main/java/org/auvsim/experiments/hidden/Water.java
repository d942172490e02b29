package org.auvsim.experiments.hidden;

import org.apache.commons.math3.geometry.euclidean.threed.Vector3D;

/** How the water (or the air) moves. */
@FunctionalInterface
interface Water {
    Water STILL = (position, time) -> Vector3D.ZERO;

    /** Half the time (s) over which the acceleration is taken. */
    double MOMENT = 1e-3;

    /** Velocity (m/s, world) at a place (m) and time (s). */
    Vector3D at(Vector3D position, double time);

    /** Of the water that is there then, along its own way (m/s^2): the material derivative. */
    default Vector3D acceleration(Vector3D position, double time) {
        Vector3D u = at(position, time);
        return at(position.add(MOMENT, u), time + MOMENT)
                .subtract(at(position.add(-MOMENT, u), time - MOMENT))
                .scalarMultiply(1 / (2 * MOMENT));
    }

    default Water plus(Water other) {
        return (position, time) -> at(position, time).add(other.at(position, time));
    }
}
