package org.auvsim.experiments.hidden;

import org.apache.commons.math3.geometry.euclidean.threed.Vector3D;
import org.apache.commons.math3.util.FastMath;

/**
 * A steered fin of a thin foil: lift across and drag along the flow in the plane square to its
 * span, by the angle of attack a. Attached flow (to {@link #STALL}): C_L = slope a, C_D = 0.01 + k
 * C_L^2; a flat plate beyond twice that, and a smooth passage between.
 *
 * @param position of its centre of pressure (m, body)
 * @param span about which it turns (unit vector, body)
 * @param area (m^2)
 * @param slope of its lift (1/rad)
 */
record Foil(String name, Vector3D position, Vector3D span, double area, double slope) {
    static final double STALL = 0.35;
    static final double DRAG = 0.01;
    static final double INDUCED = 0.1;
    static final double DENSITY = 1025;

    /**
     * Force on it (N, body axes).
     *
     * @param flow its centre's velocity through the water (m/s, body axes)
     * @param angle by which it is turned (rad)
     */
    Vector3D force(Vector3D flow, double angle) {
        Vector3D across = flow.subtract(span.scalarMultiply(flow.dotProduct(span)));
        double speed = across.getNorm();
        if (speed == 0) {
            return Vector3D.ZERO;
        }
        Vector3D normal = span.crossProduct(across);
        double attack = FastMath.atan2(normal.getX(), across.getX()) + angle;
        double x = FastMath.max(0, FastMath.min(1, FastMath.abs(attack) / STALL - 1));
        double stalled = x * x * (3 - 2 * x);
        double sine = FastMath.sin(attack);
        double attached = slope * attack;
        double lift = (1 - stalled) * attached + stalled * 2 * sine * FastMath.cos(attack);
        double drag =
                DRAG + (1 - stalled) * INDUCED * attached * attached + stalled * 2 * sine * sine;
        return new Vector3D(lift, normal, -drag, across)
                .scalarMultiply(0.5 * DENSITY * area * speed);
    }
}
