package org.auvsim.core.math;

import java.util.Optional;

/** A 3x3 matrix; {@code xy} is row x, column y. */
public record Mat3(
        double xx,
        double xy,
        double xz,
        double yx,
        double yy,
        double yz,
        double zx,
        double zy,
        double zz) {
    /** Ones on the diagonal. */
    public static final Mat3 IDENTITY = diagonal(1, 1, 1);

    /** The matrix with these numbers on the diagonal and zeros beside it. */
    public static Mat3 diagonal(double xx, double yy, double zz) {
        return new Mat3(xx, 0, 0, 0, yy, 0, 0, 0, zz);
    }

    /** This times the column vector {@code v}. */
    public Vec3 times(Vec3 v) {
        return new Vec3(
                xx * v.x() + xy * v.y() + xz * v.z(),
                yx * v.x() + yy * v.y() + yz * v.z(),
                zx * v.x() + zy * v.y() + zz * v.z());
    }

    /** Matrix product this * {@code o}. */
    public Mat3 times(Mat3 o) {
        return new Mat3(
                xx * o.xx + xy * o.yx + xz * o.zx,
                xx * o.xy + xy * o.yy + xz * o.zy,
                xx * o.xz + xy * o.yz + xz * o.zz,
                yx * o.xx + yy * o.yx + yz * o.zx,
                yx * o.xy + yy * o.yy + yz * o.zy,
                yx * o.xz + yy * o.yz + yz * o.zz,
                zx * o.xx + zy * o.yx + zz * o.zx,
                zx * o.xy + zy * o.yy + zz * o.zy,
                zx * o.xz + zy * o.yz + zz * o.zz);
    }

    /** Rows and columns exchanged; of a rotation the opposite turn. */
    public Mat3 transposed() {
        return new Mat3(xx, yx, zx, xy, yy, zy, xz, yz, zz);
    }

    /** Determinant. */
    public double determinant() {
        return xx * (yy * zz - yz * zy) - xy * (yx * zz - yz * zx) + xz * (yx * zy - yy * zx);
    }

    /** The inverse, by cofactors; empty if the determinant is 0 or not finite. */
    public Optional<Mat3> inverse() {
        double d = determinant();
        if (d == 0 || !Double.isFinite(d)) {
            return Optional.empty();
        }
        return Optional.of(
                new Mat3(
                        (yy * zz - yz * zy) / d,
                        (xz * zy - xy * zz) / d,
                        (xy * yz - xz * yy) / d,
                        (yz * zx - yx * zz) / d,
                        (xx * zz - xz * zx) / d,
                        (xz * yx - xx * yz) / d,
                        (yx * zy - yy * zx) / d,
                        (xy * zx - xx * zy) / d,
                        (xx * yy - xy * yx) / d));
    }

    /** Whether the two halves beside the diagonal are equal, to the bit. */
    public boolean isSymmetric() {
        return xy == yx && xz == zx && yz == zy;
    }
}
