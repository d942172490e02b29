package org.auvsim.core.volume;

import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;

/**
 * A convex solid in the world as a box of none, one or three dimensions and a radius: the solid is
 * all that is no farther from the box than the radius. A sphere's core is a point, a capsule's a
 * segment, a box's the box itself.
 */
final class Core {
    /** Centre (m, world). */
    double x;

    double y;
    double z;

    /** Unit vectors along the core's edges (world): axis i at 3 i and behind. */
    final double[] axes = new double[9];

    /** Half of each edge (m). */
    final double[] half = new double[3];

    /** How many edges are longer than 0: 0, 1 or 3. */
    int dimensions;

    double radius;

    /** How far the solid reaches from the centre (m). */
    double reach;

    /** A corner or other point of the core (m, world). */
    double cx;

    double cy;
    double cz;

    /** Of how many convex parts a bounded volume of this package consists. */
    static int parts(Volume volume) {
        return volume instanceof Compound compound ? compound.part().size() : 1;
    }

    /** Becomes part {@code i} of a bounded volume of this package in a pose. */
    void place(Volume volume, int i, Pose pose) {
        if (volume instanceof Compound compound) {
            place(compound.part().get(i), pose);
        } else {
            place(volume, pose.x, pose.y, pose.z, pose.qw, pose.qx, pose.qy, pose.qz);
        }
    }

    private void place(Part part, Pose p) {
        Vec3 at = part.position();
        Quat q = part.orientation();
        turn(p.qw, p.qx, p.qy, p.qz);
        place(
                part.volume(),
                p.x + axes[0] * at.x() + axes[3] * at.y() + axes[6] * at.z(),
                p.y + axes[1] * at.x() + axes[4] * at.y() + axes[7] * at.z(),
                p.z + axes[2] * at.x() + axes[5] * at.y() + axes[8] * at.z(),
                p.qw * q.w() - p.qx * q.x() - p.qy * q.y() - p.qz * q.z(),
                p.qw * q.x() + p.qx * q.w() + p.qy * q.z() - p.qz * q.y(),
                p.qw * q.y() - p.qx * q.z() + p.qy * q.w() + p.qz * q.x(),
                p.qw * q.z() + p.qx * q.y() - p.qy * q.x() + p.qz * q.w());
    }

    private void place(
            Volume volume,
            double px,
            double py,
            double pz,
            double qw,
            double qx,
            double qy,
            double qz) {
        x = px;
        y = py;
        z = pz;
        turn(qw, qx, qy, qz);
        switch (volume) {
            case Sphere sphere -> shape(0, 0, 0, 0, sphere.radius());
            case Capsule capsule -> shape(1, capsule.length() / 2, 0, 0, capsule.radius());
            case Box box -> shape(3, box.size().x() / 2, box.size().y() / 2, box.size().z() / 2, 0);
            default -> throw new IllegalArgumentException(volume + " is not convex");
        }
    }

    private void shape(int edges, double hx, double hy, double hz, double swept) {
        dimensions = edges;
        half[0] = hx;
        half[1] = hy;
        half[2] = hz;
        radius = swept;
        reach = swept + (edges == 3 ? Math.sqrt(hx * hx + hy * hy + hz * hz) : hx);
    }

    private void turn(double w, double i, double j, double k) {
        axes[0] = 1 - 2 * (j * j + k * k);
        axes[1] = 2 * (i * j + w * k);
        axes[2] = 2 * (i * k - w * j);
        axes[3] = 2 * (i * j - w * k);
        axes[4] = 1 - 2 * (i * i + k * k);
        axes[5] = 2 * (j * k + w * i);
        axes[6] = 2 * (i * k + w * j);
        axes[7] = 2 * (j * k - w * i);
        axes[8] = 1 - 2 * (i * i + j * j);
    }

    /** How far the core, without the radius, reaches from its centre along a vector. */
    double along(double vx, double vy, double vz) {
        double sum = 0;
        for (int i = 0; i < dimensions; i++) {
            sum +=
                    half[i]
                            * Math.abs(
                                    axes[3 * i] * vx + axes[3 * i + 1] * vy + axes[3 * i + 2] * vz);
        }
        return sum;
    }

    /** Puts corner {@code i} of the core, 0 to 2^dimensions - 1, into cx, cy, cz. */
    void corner(int i) {
        cx = x;
        cy = y;
        cz = z;
        for (int k = 0; k < dimensions; k++) {
            move(k, (i >> k & 1) == 0 ? half[k] : -half[k]);
        }
    }

    /** Moves cx, cy, cz along axis {@code i}. */
    void move(int i, double step) {
        cx += step * axes[3 * i];
        cy += step * axes[3 * i + 1];
        cz += step * axes[3 * i + 2];
    }

    /** Writes least x, y, z, then greatest x, y, z. */
    void bounds(double[] to) {
        for (int k = 0; k < 3; k++) {
            double sum = radius;
            for (int i = 0; i < dimensions; i++) {
                sum += half[i] * Math.abs(axes[3 * i + k]);
            }
            double centre = k == 0 ? x : k == 1 ? y : z;
            to[k] = centre - sum;
            to[3 + k] = centre + sum;
        }
    }

    /** Component of a vector along axis {@code i}. */
    double component(int i, double vx, double vy, double vz) {
        return axes[3 * i] * vx + axes[3 * i + 1] * vy + axes[3 * i + 2] * vz;
    }
}
