package org.auvsim.core.step;

import org.auvsim.core.entity.BodyState;

/** What two bodies do that touch: the impulse along the normal, and what it changes. */
final class Bounce {
    /** Bodies that approach slower than this (m/s) do so by rounding only. */
    private static final double APPROACH_TOLERANCE = 1e-10;

    private final BodyState bodies;
    private final BodyTraits traits;

    Bounce(BodyState bodies, BodyTraits traits) {
        this.bodies = bodies;
        this.traits = traits;
    }

    /** Lets two spheres bounce that touch now; false if they part already. */
    boolean between(int a, int b) {
        double[] x = bodies.column(BodyState.X);
        double[] y = bodies.column(BodyState.Y);
        double[] z = bodies.column(BodyState.Z);
        double[] px = bodies.column(BodyState.PX);
        double[] py = bodies.column(BodyState.PY);
        double[] pz = bodies.column(BodyState.PZ);
        double ma = bodies.inverseMass()[a];
        double mb = bodies.inverseMass()[b];
        double nx = x[a] - x[b];
        double ny = y[a] - y[b];
        double nz = z[a] - z[b];
        double distance = Math.sqrt(nx * nx + ny * ny + nz * nz);
        nx /= distance;
        ny /= distance;
        nz /= distance;
        double approach =
                -(nx * (px[a] * ma - px[b] * mb)
                        + ny * (py[a] * ma - py[b] * mb)
                        + nz * (pz[a] * ma - pz[b] * mb));
        if (approach <= APPROACH_TOLERANCE) {
            return false;
        }
        double e = Math.min(traits.restitution[a], traits.restitution[b]);
        double j = (1 + e) * approach / (ma + mb);
        double jx = j * nx;
        double jy = j * ny;
        double jz = j * nz;
        if (ma > 0) {
            px[a] += jx;
            py[a] += jy;
            pz[a] += jz;
        }
        if (mb > 0) {
            px[b] -= jx;
            py[b] -= jy;
            pz[b] -= jz;
        }
        return true;
    }

    Collision collision(Motion motion, double t) {
        throw new UnsupportedOperationException();
    }
}
