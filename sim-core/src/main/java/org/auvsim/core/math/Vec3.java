package org.auvsim.core.math;

/** A vector of three numbers, in whatever frame and unit its holder states. */
public record Vec3(double x, double y, double z) {
    /** (0, 0, 0). */
    public static final Vec3 ZERO = new Vec3(0, 0, 0);

    /**
     * One of the three numbers: x of axis 0, y of 1, z of 2.
     *
     * @throws IllegalArgumentException if the axis is none of these
     */
    public double component(int axis) {
        return switch (axis) {
            case 0 -> x;
            case 1 -> y;
            case 2 -> z;
            default -> throw new IllegalArgumentException("an axis is 0, 1 or 2, but not " + axis);
        };
    }

    /** This plus {@code o}. */
    public Vec3 plus(Vec3 o) {
        return new Vec3(x + o.x, y + o.y, z + o.z);
    }

    /** This minus {@code o}. */
    public Vec3 minus(Vec3 o) {
        return new Vec3(x - o.x, y - o.y, z - o.z);
    }

    /** This, each component multiplied by {@code factor}. */
    public Vec3 times(double factor) {
        return new Vec3(x * factor, y * factor, z * factor);
    }

    /** The opposite vector; exactly, so that impulses of action and reaction cancel bit for bit. */
    public Vec3 negated() {
        return new Vec3(-x, -y, -z);
    }

    /** Scalar product. */
    public double dot(Vec3 o) {
        return x * o.x + y * o.y + z * o.z;
    }

    /** Vector product this x {@code o}. */
    public Vec3 cross(Vec3 o) {
        return new Vec3(y * o.z - z * o.y, z * o.x - x * o.z, x * o.y - y * o.x);
    }

    /** Euclidean length. */
    public double norm() {
        return Math.sqrt(dot(this));
    }

    /** Euclidean distance to {@code o}. */
    public double distance(Vec3 o) {
        return minus(o).norm();
    }

    /**
     * The vector of length 1 in this direction.
     *
     * @throws IllegalArgumentException if the length is 0 or too large for a number
     */
    public Vec3 normalized() {
        double norm = norm();
        if (!(norm > 0) || Double.isInfinite(norm)) {
            throw new IllegalArgumentException(
                    "a direction needs a finite length above 0, but " + this + " has " + norm);
        }
        return times(1 / norm);
    }

    /** Whether no component is infinite or NaN. */
    public boolean isFinite() {
        return Double.isFinite(x) && Double.isFinite(y) && Double.isFinite(z);
    }

    @Override
    public String toString() {
        return "(" + x + ", " + y + ", " + z + ")";
    }
}
