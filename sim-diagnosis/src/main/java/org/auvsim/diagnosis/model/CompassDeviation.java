package org.auvsim.diagnosis.model;

import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;

/**
 * By how much a compass is off to the left because of iron that turns with the body: by another
 * angle on each heading (the semicircular part of a compass' deviation, coefficients B and C).
 *
 * @param sine of the heading, which is from x on to the left, times this (rad)
 * @param cosine of the heading, times this (rad)
 */
record CompassDeviation(double sine, double cosine) {
    /** A compass that no iron disturbs. */
    static final CompassDeviation NONE = new CompassDeviation(0, 0);

    private static final Vec3 AHEAD = new Vec3(1, 0, 0);

    /** The same beside more iron. */
    CompassDeviation plus(CompassDeviation more) {
        return new CompassDeviation(sine + more.sine, cosine + more.cosine);
    }

    /** How far off (rad) it is on a body that lies so. */
    double of(Quat orientation) {
        Vec3 ahead = orientation.rotate(AHEAD);
        double level = Math.sqrt(ahead.x() * ahead.x() + ahead.y() * ahead.y());
        return level == 0 ? 0 : (sine * ahead.y() + cosine * ahead.x()) / level;
    }
}
