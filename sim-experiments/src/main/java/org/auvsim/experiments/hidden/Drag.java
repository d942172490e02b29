package org.auvsim.experiments.hidden;

import org.apache.commons.math3.geometry.euclidean.threed.Vector3D;

/**
 * Drag by body axes, F_i = -(linear_i + quadratic_i |v_i|) v_i and the same of turning, and alike
 * in all directions, F = -(evenLinear + evenQuadratic |v|) v, T = -evenAngular w.
 */
record Drag(
        Vector3D linear,
        Vector3D quadratic,
        Vector3D angularLinear,
        Vector3D angularQuadratic,
        double evenLinear,
        double evenQuadratic,
        double evenAngular) {
    static Drag even(double linear, double quadratic, double angular) {
        return new Drag(
                Vector3D.ZERO,
                Vector3D.ZERO,
                Vector3D.ZERO,
                Vector3D.ZERO,
                linear,
                quadratic,
                angular);
    }

    static Drag byAxes(
            Vector3D linear,
            Vector3D quadratic,
            Vector3D angularLinear,
            Vector3D angularQuadratic) {
        return new Drag(linear, quadratic, angularLinear, angularQuadratic, 0, 0, 0);
    }

    /** On a body that moves so through the water (body axes). */
    Vector3D force(Vector3D v) {
        return resisted(linear, quadratic, v).add(-(evenLinear + evenQuadratic * v.getNorm()), v);
    }

    /** On a body that turns so (body axes). */
    Vector3D torque(Vector3D w) {
        return resisted(angularLinear, angularQuadratic, w).add(-evenAngular, w);
    }

    private static Vector3D resisted(Vector3D a, Vector3D b, Vector3D v) {
        return new Vector3D(
                -(a.getX() + b.getX() * Math.abs(v.getX())) * v.getX(),
                -(a.getY() + b.getY() * Math.abs(v.getY())) * v.getY(),
                -(a.getZ() + b.getZ() * Math.abs(v.getZ())) * v.getZ());
    }

    Drag withQuadratic(Vector3D more) {
        return new Drag(
                linear,
                quadratic.add(more),
                angularLinear,
                angularQuadratic,
                evenLinear,
                evenQuadratic,
                evenAngular);
    }

    Drag withEven(double moreLinear, double moreQuadratic, double moreAngular) {
        return new Drag(
                linear,
                quadratic,
                angularLinear,
                angularQuadratic,
                evenLinear + moreLinear,
                evenQuadratic + moreQuadratic,
                evenAngular + moreAngular);
    }
}
