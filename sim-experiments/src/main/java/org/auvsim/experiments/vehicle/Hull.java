package org.auvsim.experiments.vehicle;

import org.auvsim.core.math.Vec3;
import org.auvsim.core.volume.Capsule;
import org.auvsim.core.volume.Pose;
import org.auvsim.core.volume.Sphere;
import org.auvsim.core.volume.Volume;

/**
 * The shape of a vehicle as rules of thumb see it.
 *
 * @param size length, breadth and height (m) of the box along its axes that holds it
 * @param isRound whether all its sections across the length are circles
 */
record Hull(Vec3 size, boolean isRound) {
    /** From this length in diameters on strip theory is trusted. */
    private static final double SLENDER = 3;

    static Hull of(Volume volume) {
        Pose pose = new Pose();
        pose.qw = 1;
        double[] bounds = new double[6];
        volume.bounds(pose, bounds, 0);
        return new Hull(
                new Vec3(bounds[3] - bounds[0], bounds[4] - bounds[1], bounds[5] - bounds[2]),
                volume instanceof Capsule || volume instanceof Sphere);
    }

    /** Whether strip theory holds: long and round. */
    boolean isSlender() {
        return isRound && size.x() >= SLENDER * size.y();
    }

    /** Radius (m) of a round hull's section at a place along its length from its middle (m). */
    double radius(double x) {
        double end = size.y() / 2;
        double beyond = Math.abs(x) - (size.x() / 2 - end);
        return beyond <= 0 ? end : Math.sqrt(Math.max(end * end - beyond * beyond, 0));
    }

    /** The ellipsoid of the hull's proportions that displaces a volume (m^3). */
    Ellipsoid ellipsoid(double displaced) {
        double ofBox = Math.PI / 6 * size.x() * size.y() * size.z();
        double scale = StrictMath.cbrt(displaced / ofBox) / 2;
        return new Ellipsoid(scale * size.x(), scale * size.y(), scale * size.z());
    }
}
