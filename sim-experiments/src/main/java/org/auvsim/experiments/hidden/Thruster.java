package org.auvsim.experiments.hidden;

import org.apache.commons.math3.geometry.euclidean.threed.Vector3D;
import org.apache.commons.math3.util.FastMath;

/**
 * A thruster whose thrust is in proportion to its level, -1 to 1, but for what is wrong with it.
 *
 * @param position where it pushes (m, body)
 * @param direction where to (unit vector, body)
 * @param most thrust at level 1 (N)
 * @param gain factor of all thrust
 * @param deadZone what is taken off the size of a level
 * @param lag time constant (s) with which it follows
 * @param lostFrom when it stops for good (s)
 */
record Thruster(
        String name,
        Vector3D position,
        Vector3D direction,
        double most,
        double gain,
        double deadZone,
        double lag,
        double lostFrom) {
    static Thruster sound(String name, Vector3D position, Vector3D direction, double most) {
        return new Thruster(
                name, position, direction.normalize(), most, 1, 0, 0, Double.POSITIVE_INFINITY);
    }

    /** The level that it makes for when told one. */
    double target(double level) {
        return FastMath.copySign(FastMath.max(FastMath.abs(level) - deadZone, 0), level);
    }

    /** Along its direction (N). */
    double thrust(double level, double time) {
        return time >= lostFrom ? 0 : gain * most * level;
    }

    Thruster withGain(double factor) {
        return new Thruster(name, position, direction, most, factor, deadZone, lag, lostFrom);
    }

    Thruster withDeadZone(double width) {
        return new Thruster(name, position, direction, most, gain, width, lag, lostFrom);
    }

    Thruster withLag(double seconds) {
        return new Thruster(name, position, direction, most, gain, deadZone, seconds, lostFrom);
    }

    Thruster lostFrom(double time) {
        return new Thruster(name, position, direction, most, gain, deadZone, lag, time);
    }

    Thruster pointing(Vector3D elsewhere) {
        return new Thruster(name, position, elsewhere, most, gain, deadZone, lag, lostFrom);
    }
}
