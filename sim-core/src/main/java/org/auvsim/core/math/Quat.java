package org.auvsim.core.math;

/**
 * A quaternion w + xi + yj + zk. As an orientation it has length 1 and turns body vectors into
 * world vectors (Witkin &amp; Baraff 1997, section 4.2).
 */
public record Quat(double w, double x, double y, double z) {
    /** No turn: the body's axes are the world's. */
    public static final Quat IDENTITY = new Quat(1, 0, 0, 0);

    /**
     * The turn by {@code angle} (rad, right-handed) about {@code axis}.
     *
     * @throws IllegalArgumentException if the axis is the zero vector
     */
    public static Quat ofAxisAngle(Vec3 axis, double angle) {
        Vec3 n = axis.normalized();
        double s = StrictMath.sin(angle / 2);
        return new Quat(StrictMath.cos(angle / 2), n.x() * s, n.y() * s, n.z() * s);
    }

    /**
     * The unit quaternion of a rotation matrix, from the largest of its four squares (Shepperd
     * 1978, J. Guidance and Control 1); of q and -q the one with w of 0 or more.
     */
    public static Quat of(Mat3 m) {
        double trace = m.xx() + m.yy() + m.zz();
        double largest = Math.max(Math.max(trace, m.xx()), Math.max(m.yy(), m.zz()));
        Quat q;
        if (largest == trace) {
            q = new Quat(1 + trace, m.zy() - m.yz(), m.xz() - m.zx(), m.yx() - m.xy());
        } else if (largest == m.xx()) {
            double x = 1 + m.xx() - m.yy() - m.zz();
            q = new Quat(m.zy() - m.yz(), x, m.xy() + m.yx(), m.xz() + m.zx());
        } else if (largest == m.yy()) {
            double y = 1 + m.yy() - m.xx() - m.zz();
            q = new Quat(m.xz() - m.zx(), m.xy() + m.yx(), y, m.yz() + m.zy());
        } else {
            double z = 1 + m.zz() - m.xx() - m.yy();
            q = new Quat(m.yx() - m.xy(), m.xz() + m.zx(), m.yz() + m.zy(), z);
        }
        Quat unit = q.normalized();
        return unit.w < 0 ? new Quat(-unit.w, -unit.x, -unit.y, -unit.z) : unit;
    }

    /** The Hamilton product this * {@code o}: turn by {@code o} first, then by this. */
    public Quat times(Quat o) {
        return new Quat(
                w * o.w - x * o.x - y * o.y - z * o.z,
                w * o.x + x * o.w + y * o.z - z * o.y,
                w * o.y - x * o.z + y * o.w + z * o.x,
                w * o.z + x * o.y - y * o.x + z * o.w);
    }

    /** The conjugate; of a unit quaternion the opposite turn. */
    public Quat conjugate() {
        return new Quat(w, -x, -y, -z);
    }

    /** Euclidean length. */
    public double norm() {
        return Math.sqrt(w * w + x * x + y * y + z * z);
    }

    /**
     * The unit quaternion in this direction.
     *
     * @throws IllegalArgumentException if the length is 0 or not finite
     */
    public Quat normalized() {
        double norm = norm();
        if (!(norm > 0) || Double.isInfinite(norm)) {
            throw new IllegalArgumentException(
                    "an orientation needs a finite length above 0, but " + this + " has " + norm);
        }
        return new Quat(w / norm, x / norm, y / norm, z / norm);
    }

    /** The rotation matrix that turns body vectors into world vectors; for a unit quaternion. */
    public Mat3 toMatrix() {
        return new Mat3(
                1 - 2 * (y * y + z * z),
                2 * (x * y - w * z),
                2 * (x * z + w * y),
                2 * (x * y + w * z),
                1 - 2 * (x * x + z * z),
                2 * (y * z - w * x),
                2 * (x * z - w * y),
                2 * (y * z + w * x),
                1 - 2 * (x * x + y * y));
    }

    /** Turns a body vector into a world vector. */
    public Vec3 rotate(Vec3 body) {
        return toMatrix().times(body);
    }

    /** Turns a world vector into a body vector. */
    public Vec3 rotateInverse(Vec3 world) {
        return toMatrix().transposed().times(world);
    }

    /** Whether no component is infinite or NaN. */
    public boolean isFinite() {
        return Double.isFinite(w) && Double.isFinite(x) && Double.isFinite(y) && Double.isFinite(z);
    }

    @Override
    public String toString() {
        return "(" + w + ", " + x + ", " + y + ", " + z + ")";
    }
}
