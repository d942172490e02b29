package org.auvsim.core.step;

import org.auvsim.core.math.Draws;
import org.auvsim.core.math.Vec3;

/** A relative cubic path and a reach, with its first touch by dense sampling and bisection. */
record SphereApproach(Vec3 p0, Vec3 p1, Vec3 p2, Vec3 p3, double reach0, double reach1) {
    private static final int SAMPLES = 1_000;

    static SphereApproach drawn(Draws draws, double size, double reach0, double reach1) {
        return new SphereApproach(
                draws.vector(size),
                draws.vector(size),
                draws.vector(size),
                draws.vector(size),
                reach0,
                reach1);
    }

    static SphereApproach straight(Vec3 from, Vec3 to, double reach) {
        return straight(from, to, reach, reach);
    }

    static SphereApproach straight(Vec3 from, Vec3 to, double reach0, double reach1) {
        Vec3 third = to.minus(from).times(1.0 / 3);
        return new SphereApproach(from, from.plus(third), to.minus(third), to, reach0, reach1);
    }

    /** from + velocity s + acceleration s^2 / 2. */
    static SphereApproach thrown(Vec3 from, Vec3 velocity, Vec3 acceleration, double reach) {
        Vec3 third = velocity.times(1.0 / 3);
        Vec3 bent = acceleration.times(1.0 / 6);
        Vec3 p1 = from.plus(third);
        Vec3 p2 = from.plus(third.times(2)).plus(bent);
        Vec3 p3 = from.plus(velocity).plus(acceleration.times(0.5));
        return new SphereApproach(from, p1, p2, p3, reach, reach);
    }

    double[] points() {
        return new double[] {
            p0.x(), p0.y(), p0.z(), p1.x(), p1.y(), p1.z(),
            p2.x(), p2.y(), p2.z(), p3.x(), p3.y(), p3.z()
        };
    }

    /** The largest length in it. */
    double size() {
        double far = Math.max(Math.max(p0.norm(), p1.norm()), Math.max(p2.norm(), p3.norm()));
        return Math.max(far, Math.max(reach0, reach1));
    }

    Vec3 distance(double s) {
        double r = 1 - s;
        return p0.times(r * r * r)
                .plus(p1.times(3 * r * r * s))
                .plus(p2.times(3 * r * s * s))
                .plus(p3.times(s * s * s));
    }

    /** Positive while apart. */
    double gap(double s) {
        return distance(s).norm() - (reach0 * (1 - s) + reach1 * s);
    }

    /** First s after {@code from} where the gap closes; infinity if none. */
    double firstBySampling(double from) {
        double step = (1 - from) / SAMPLES;
        for (int i = 1; i <= SAMPLES; i++) {
            double s = from + i * step;
            if (gap(s) < 0) return bisect(s - step, s);
            if (i < SAMPLES && gap(s) <= gap(s - step) && gap(s) <= gap(s + step)) {
                double dip = lowest(s - step, s + step);
                if (gap(dip) < 0) return bisect(s - step, dip);
            }
        }
        return Double.POSITIVE_INFINITY;
    }

    double leastGapAfter(double from) {
        double step = (1 - from) / SAMPLES;
        double least = gap(1);
        for (int i = 1; i < SAMPLES; i++) {
            double s = from + i * step;
            if (gap(s) <= gap(s - step) && gap(s) <= gap(s + step)) {
                least = Math.min(least, gap(lowest(s - step, s + step)));
            }
        }
        return least;
    }

    private double lowest(double low, double high) {
        for (int i = 0; i < 80; i++) {
            double a = low + (high - low) / 3, b = high - (high - low) / 3;
            if (gap(a) < gap(b)) high = b;
            else low = a;
        }
        return 0.5 * (low + high);
    }

    private double bisect(double apart, double overlapping) {
        for (int i = 0; i < 60; i++) {
            double middle = 0.5 * (apart + overlapping);
            if (gap(middle) < 0) overlapping = middle;
            else apart = middle;
        }
        return apart;
    }
}
