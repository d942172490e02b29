package org.auvsim.core.dynamics;

import static org.auvsim.core.entity.BodyState.IXX;
import static org.auvsim.core.entity.BodyState.IXY;
import static org.auvsim.core.entity.BodyState.IXZ;
import static org.auvsim.core.entity.BodyState.IYY;
import static org.auvsim.core.entity.BodyState.IYZ;
import static org.auvsim.core.entity.BodyState.IZZ;
import static org.auvsim.core.entity.BodyState.LX;
import static org.auvsim.core.entity.BodyState.LY;
import static org.auvsim.core.entity.BodyState.LZ;
import static org.auvsim.core.entity.BodyState.QW;
import static org.auvsim.core.entity.BodyState.QX;
import static org.auvsim.core.entity.BodyState.QY;
import static org.auvsim.core.entity.BodyState.QZ;

import org.auvsim.core.entity.Block;

/**
 * The loops over a block that have to do with how its bodies turn.
 *
 * <p>They are short on purpose: each touches few enough arrays for the compiler to vectorise it.
 */
final class Rotation {
    private Rotation() {}

    /**
     * Fills the rotation matrices. Between the stages of a step quaternions have other lengths than
     * 1, the more the faster a body spins: 2 over the square of that makes the matrices rotations.
     */
    static void matrices(Block b) {
        double[] w = b.state[QW];
        double[] x = b.state[QX];
        double[] y = b.state[QY];
        double[] z = b.state[QZ];
        double[] s = b.scratch[0];
        for (int i = 0; i < b.count; i++) {
            s[i] = 2 / (w[i] * w[i] + x[i] * x[i] + y[i] * y[i] + z[i] * z[i]);
        }
        for (int i = 0; i < b.count; i++) {
            b.rxx[i] = 1 - s[i] * (y[i] * y[i] + z[i] * z[i]);
            b.rxy[i] = s[i] * (x[i] * y[i] - w[i] * z[i]);
            b.rxz[i] = s[i] * (x[i] * z[i] + w[i] * y[i]);
        }
        for (int i = 0; i < b.count; i++) {
            b.ryx[i] = s[i] * (x[i] * y[i] + w[i] * z[i]);
            b.ryy[i] = 1 - s[i] * (x[i] * x[i] + z[i] * z[i]);
            b.ryz[i] = s[i] * (y[i] * z[i] - w[i] * x[i]);
        }
        for (int i = 0; i < b.count; i++) {
            b.rzx[i] = s[i] * (x[i] * z[i] - w[i] * y[i]);
            b.rzy[i] = s[i] * (y[i] * z[i] + w[i] * x[i]);
            b.rzz[i] = 1 - s[i] * (x[i] * x[i] + y[i] * y[i]);
        }
    }

    /** Fills the angular velocities in the bodies' axes: I^-1 R^T L. */
    static void bodyRates(Block b) {
        double[] x = b.scratch[0];
        double[] y = b.scratch[1];
        double[] z = b.scratch[2];
        b.toBody(x, y, z, b.state[LX], b.state[LY], b.state[LZ]);
        if (b.hasProducts) {
            weigh(b, b.bodyWx, IXX, IXY, IXZ);
            weigh(b, b.bodyWy, IXY, IYY, IYZ);
            weigh(b, b.bodyWz, IXZ, IYZ, IZZ);
        } else {
            weigh(b, b.bodyWx, x, IXX);
            weigh(b, b.bodyWy, y, IYY);
            weigh(b, b.bodyWz, z, IZZ);
        }
    }

    private static void weigh(Block b, double[] to, int x, int y, int z) {
        double[] ix = b.inverseInertia[x];
        double[] iy = b.inverseInertia[y];
        double[] iz = b.inverseInertia[z];
        double[] lx = b.scratch[0];
        double[] ly = b.scratch[1];
        double[] lz = b.scratch[2];
        for (int i = 0; i < b.count; i++) {
            to[i] = ix[i] * lx[i] + iy[i] * ly[i] + iz[i] * lz[i];
        }
    }

    private static void weigh(Block b, double[] to, double[] l, int axis) {
        double[] inverse = b.inverseInertia[axis];
        for (int i = 0; i < b.count; i++) {
            to[i] = inverse[i] * l[i];
        }
    }

    /** dq/dt = 1/2 q [0, w] with w in the body's axes. */
    static void quaternionRates(Block b) {
        double[] qw = b.state[QW];
        double[] qx = b.state[QX];
        double[] qy = b.state[QY];
        double[] qz = b.state[QZ];
        double[] wx = b.bodyWx;
        double[] wy = b.bodyWy;
        double[] wz = b.bodyWz;
        double[] dw = b.rate[QW];
        double[] dx = b.rate[QX];
        double[] dy = b.rate[QY];
        double[] dz = b.rate[QZ];
        for (int i = 0; i < b.count; i++) {
            dw[i] = -0.5 * (qx[i] * wx[i] + qy[i] * wy[i] + qz[i] * wz[i]);
            dx[i] = 0.5 * (qw[i] * wx[i] + qy[i] * wz[i] - qz[i] * wy[i]);
        }
        for (int i = 0; i < b.count; i++) {
            dy[i] = 0.5 * (qw[i] * wy[i] + qz[i] * wx[i] - qx[i] * wz[i]);
            dz[i] = 0.5 * (qw[i] * wz[i] + qx[i] * wy[i] - qy[i] * wx[i]);
        }
    }

    /** Scales the quaternions back to length 1; a zero comes out without a sign. */
    static void normalize(Block b) {
        double[] qw = b.state[QW];
        double[] qx = b.state[QX];
        double[] qy = b.state[QY];
        double[] qz = b.state[QZ];
        for (int i = 0; i < b.count; i++) {
            double norm = Math.sqrt(qw[i] * qw[i] + qx[i] * qx[i] + qy[i] * qy[i] + qz[i] * qz[i]);
            double k = 1 / norm;
            qw[i] = qw[i] * k + 0.0;
            qx[i] = qx[i] * k + 0.0;
            qy[i] = qy[i] * k + 0.0;
            qz[i] = qz[i] * k + 0.0;
        }
    }
}
