package org.auvsim.core.step;

import org.auvsim.core.volume.Capsule;
import org.auvsim.core.volume.Sphere;
import org.auvsim.core.volume.Volume;

/**
 * Bounds of how two volumes on their curves move against each other, between two times.
 *
 * <p>A point of a volume moves with its body's origin and turns about it, at most its radius away.
 * So along a fixed direction n (unit, from b to a) every point of a nears every point of b at most
 * as fast as the origins do plus |w| r of both; that is {@link #closing}. Its second derivative is
 * bounded in the same way: {@link #bend}.
 */
final class RelativeMotion {
    private final double[] velocity = new double[9];
    private final double[] acceleration = new double[6];
    private final double[] other = new double[9];
    private double turning;
    private double turningBend;

    /**
     * Looks at two volumes from {@code t0} on, as far as it can: to {@code t1}, or not as far if
     * they turn so much that up to there nothing can be said.
     *
     * @return the time up to which the bounds hold
     */
    double look(BodyCurve a, Volume va, BodyCurve b, Volume vb, double t0, double t1) {
        double until = t1;
        while (true) {
            turning = 0;
            turningBend = 0;
            addTurn(a, va, t0, until);
            addTurn(b, vb, t0, until);
            if (turning < Double.POSITIVE_INFINITY || !(until > t0)) {
                break;
            }
            until = t0 + (until - t0) / 2;
        }
        subtract(a, b, t0, until);
        return until;
    }

    private void subtract(BodyCurve a, BodyCurve b, double t0, double t1) {
        a.velocityWithin(t0, t1, velocity, 0);
        b.velocityWithin(t0, t1, other, 0);
        for (int i = 0; i < 9; i++) {
            velocity[i] -= other[i];
        }
        a.accelerationAt(t0, t1, acceleration, 0);
        b.accelerationAt(t0, t1, other, 0);
        for (int i = 0; i < 6; i++) {
            acceleration[i] -= other[i];
        }
    }

    private void addTurn(BodyCurve curve, Volume volume, double t0, double t1) {
        double radius = curve.turns() ? turningRadius(volume) : 0;
        if (radius > 0) {
            curve.boundTurn(t0, t1);
            turning += radius * curve.angularSpeed();
            turningBend += radius * curve.angularBend();
        }
    }

    /**
     * How far from the origin (m) lie the points that turning moves. Balls look the same from all
     * sides, and a capsule is a segment with a ball about each of its points.
     */
    private static double turningRadius(Volume volume) {
        if (volume instanceof Sphere) {
            return 0;
        }
        return volume instanceof Capsule capsule ? capsule.length() / 2 : volume.boundingRadius();
    }

    /** Upper bound (m/s) of how fast the gap closes, whatever its direction. */
    double closing() {
        double square = 0;
        for (int i = 0; i < 9; i += 3) {
            double x = velocity[i];
            double y = velocity[i + 1];
            double z = velocity[i + 2];
            square = Math.max(square, x * x + y * y + z * z);
        }
        return Math.sqrt(square) + turning;
    }

    /** Upper bound (m/s) of how fast the gap along n closes; 0 or less if it does not. */
    double closing(double nx, double ny, double nz) {
        double least = Double.POSITIVE_INFINITY;
        for (int i = 0; i < 9; i += 3) {
            double along = nx * velocity[i] + ny * velocity[i + 1] + nz * velocity[i + 2];
            least = Math.min(least, along);
        }
        return turning - least;
    }

    /**
     * Upper bound, 0 or more (m/s^2), of the second derivative of the distance along n between any
     * point of a and any point of b: how far the gap can sag between two times.
     */
    double bend(double nx, double ny, double nz) {
        double first = nx * acceleration[0] + ny * acceleration[1] + nz * acceleration[2];
        double last = nx * acceleration[3] + ny * acceleration[4] + nz * acceleration[5];
        return Math.max(0, Math.max(first, last)) + turningBend;
    }
}
