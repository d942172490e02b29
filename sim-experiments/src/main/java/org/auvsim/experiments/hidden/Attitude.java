package org.auvsim.experiments.hidden;

import org.apache.commons.math3.geometry.euclidean.threed.Vector3D;
import org.apache.commons.math3.util.FastMath;

/** A unit quaternion that turns body into world vectors. */
record Attitude(double w, double x, double y, double z) {
    static final Attitude LEVEL = new Attitude(1, 0, 0, 0);

    /** The turn by a rotation vector (rad). */
    static Attitude turned(Vector3D turn) {
        double angle = turn.getNorm();
        double s = angle < 1e-12 ? 0.5 : FastMath.sin(angle / 2) / angle;
        return new Attitude(
                FastMath.cos(angle / 2), s * turn.getX(), s * turn.getY(), s * turn.getZ());
    }

    /** This turn after another one. */
    Attitude after(Attitude o) {
        return new Attitude(
                w * o.w - x * o.x - y * o.y - z * o.z,
                w * o.x + x * o.w + y * o.z - z * o.y,
                w * o.y + y * o.w + z * o.x - x * o.z,
                w * o.z + z * o.w + x * o.y - y * o.x);
    }

    Attitude normalized() {
        double length = FastMath.sqrt(w * w + x * x + y * y + z * z);
        return new Attitude(w / length, x / length, y / length, z / length);
    }

    Vector3D toWorld(Vector3D v) {
        Vector3D q = new Vector3D(x, y, z);
        Vector3D t = q.crossProduct(v).scalarMultiply(2);
        return v.add(w, t).add(q.crossProduct(t));
    }

    Vector3D toBody(Vector3D v) {
        return new Attitude(w, -x, -y, -z).toWorld(v);
    }

    /** How far (rad) another one is turned. */
    double angleTo(Attitude o) {
        double dot = FastMath.abs(w * o.w + x * o.x + y * o.y + z * o.z);
        return 2 * FastMath.acos(FastMath.min(1, dot));
    }
}
