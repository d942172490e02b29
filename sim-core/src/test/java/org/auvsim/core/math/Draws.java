package org.auvsim.core.math;

import java.util.SplittableRandom;

/** Random geometry from a seed, for tests. */
public final class Draws {
    private final SplittableRandom random;

    /** The draws that belong to this seed. */
    public Draws(long seed) {
        random = new SplittableRandom(seed);
    }

    /** A number from {@code low} to {@code high}. */
    public double number(double low, double high) {
        return random.nextDouble(low, high);
    }

    /** A vector with each component from -size to size. */
    public Vec3 vector(double size) {
        return new Vec3(number(-size, size), number(-size, size), number(-size, size));
    }

    /** A vector with each component from {@code low} to {@code high}. */
    public Vec3 vector(double low, double high) {
        return new Vec3(number(low, high), number(low, high), number(low, high));
    }

    /** A unit vector. */
    public Vec3 direction() {
        Vec3 v = vector(1);
        return v.norm() > 0.01 && v.norm() < 1 ? v.normalized() : direction();
    }

    /** A unit quaternion. */
    public Quat orientation() {
        Quat q = new Quat(number(-1, 1), number(-1, 1), number(-1, 1), number(-1, 1));
        return q.norm() > 0.01 && q.norm() < 1 ? q.normalized() : orientation();
    }

    /** A matrix with each element from -size to size. */
    public Mat3 matrix(double size) {
        Vec3 x = vector(size);
        Vec3 y = vector(size);
        Vec3 z = vector(size);
        return new Mat3(x.x(), x.y(), x.z(), y.x(), y.y(), y.z(), z.x(), z.y(), z.z());
    }
}
