package org.auvsim.core.entity;

import org.auvsim.core.math.Mat3;
import org.auvsim.core.math.Vec3;

/**
 * The inverse of a body's 6x6 inertia about its origin, in world axes: what an impulse P and an
 * angular impulse L change, v by {@code linear * P + coupling * L} and w by {@code coupling^T * P +
 * angular * L}. All zeros for a fixed body.
 *
 * @param linear 1/kg
 * @param coupling 1/(kg m); zeros if the origin is the centre of mass of a dry body
 * @param angular 1/(kg m^2)
 */
public record Mobility(Mat3 linear, Mat3 coupling, Mat3 angular) {
    static Mobility of(double[] k) {
        return new Mobility(block(k, 0), block(k, 3), block(k, 21));
    }

    private static Mat3 block(double[] k, int at) {
        return new Mat3(
                k[at],
                k[at + 1],
                k[at + 2],
                k[at + 6],
                k[at + 7],
                k[at + 8],
                k[at + 12],
                k[at + 13],
                k[at + 14]);
    }

    /** Writes it as a 6x6 matrix, row by row: 36 numbers from {@code to[at]} on. */
    public void write(double[] to, int at) {
        write(linear, to, at);
        write(coupling, to, at + 3);
        write(coupling.transposed(), to, at + 18);
        write(angular, to, at + 21);
    }

    private static void write(Mat3 m, double[] to, int at) {
        to[at] = m.xx();
        to[at + 1] = m.xy();
        to[at + 2] = m.xz();
        to[at + 6] = m.yx();
        to[at + 7] = m.yy();
        to[at + 8] = m.yz();
        to[at + 12] = m.zx();
        to[at + 13] = m.zy();
        to[at + 14] = m.zz();
    }

    /**
     * How much velocity (m/s) an impulse (N s) at a point gives the body's material there; {@code
     * r} is the point from the origin (m). All in world axes.
     */
    public Vec3 velocityAt(Vec3 r, Vec3 impulse) {
        Vec3 turn = r.cross(impulse);
        Vec3 velocity = linear.times(impulse).plus(coupling.times(turn));
        Vec3 angular = coupling.transposed().times(impulse).plus(this.angular.times(turn));
        return velocity.plus(angular.cross(r));
    }
}
