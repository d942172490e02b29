package org.auvsim.core.volume;

import org.auvsim.core.description.Default;
import org.auvsim.core.description.ElementName;
import org.auvsim.core.description.Unit;
import org.auvsim.core.math.Mat3;
import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;

/**
 * A convex part of a {@link Compound}.
 *
 * @param volume a sphere, a capsule or a box
 * @param position of its origin (m, compound's coordinates)
 * @param orientation its coordinates to the compound's; normalised here
 */
public record Part(
        Volume volume,
        @Unit("m") @Default("0 0 0") Vec3 position,
        @Default("1 0 0 0") Quat orientation) {
    /**
     * A checked part.
     *
     * @throws IllegalArgumentException if the volume is none of the three, or a number of the
     *     placement is not finite
     */
    public Part {
        if (!(volume instanceof Sphere || volume instanceof Capsule || volume instanceof Box)) {
            throw new IllegalArgumentException(
                    "a part of a compound must be a sphere, a capsule or a box, but is a "
                            + ElementName.of(volume.getClass()));
        }
        if (!position.isFinite()) {
            throw new IllegalArgumentException(
                    "the position of a compound's part must be finite, but is " + position + " m");
        }
        if (!orientation.isFinite()) {
            throw new IllegalArgumentException(
                    "the orientation of a compound's part must be finite, but is " + orientation);
        }
        if (Math.abs(orientation.norm() - 1) > 1e-15) {
            orientation = orientation.normalized();
        }
    }

    /** What it fills (m^3). */
    double cubicMetres() {
        return switch (volume) {
            case Sphere(double r) -> 4.0 / 3 * Math.PI * r * r * r;
            case Capsule(double r, double length) -> Math.PI * r * r * (length + 4 * r / 3);
            case Box(Vec3 size) -> size.x() * size.y() * size.z();
            default -> throw new IllegalStateException(volume + " is no part");
        };
    }

    /** Its inertia about {@code centre}, compound's axes (parallel-axis theorem). */
    Mat3 inertia(double mass, Vec3 centre) {
        Mat3 turn = orientation.toMatrix();
        Mat3 own = turn.times(volume.inertia(mass)).times(turn.transposed());
        Vec3 d = position.minus(centre);
        double dd = d.dot(d);
        return new Mat3(
                own.xx() + mass * (dd - d.x() * d.x()),
                own.xy() - mass * d.x() * d.y(),
                own.xz() - mass * d.x() * d.z(),
                own.xy() - mass * d.x() * d.y(),
                own.yy() + mass * (dd - d.y() * d.y()),
                own.yz() - mass * d.y() * d.z(),
                own.xz() - mass * d.x() * d.z(),
                own.yz() - mass * d.y() * d.z(),
                own.zz() + mass * (dd - d.z() * d.z()));
    }

    /** How far its farthest point is from the compound's origin (m). */
    double farthest() {
        Vec3 half =
                switch (volume) {
                    case Capsule capsule -> new Vec3(capsule.length() / 2, 0, 0);
                    case Box box -> box.halfSize();
                    default -> Vec3.ZERO;
                };
        Vec3 centre = orientation.rotateInverse(position);
        Vec3 corner =
                new Vec3(
                        Math.abs(centre.x()) + half.x(),
                        Math.abs(centre.y()) + half.y(),
                        Math.abs(centre.z()) + half.z());
        double swept =
                switch (volume) {
                    case Sphere sphere -> sphere.radius();
                    case Capsule capsule -> capsule.radius();
                    default -> 0;
                };
        return corner.norm() + swept;
    }

    /** Whether it holds a point of the compound's coordinates. */
    boolean contains(Vec3 point) {
        return volume.contains(orientation.rotateInverse(point.minus(position)));
    }

    /** How far it reaches from the compound's origin along a unit vector of its coordinates (m). */
    double reach(double nx, double ny, double nz) {
        Quat q = orientation;
        double along = position.x() * nx + position.y() * ny + position.z() * nz;
        double x = Turn.componentBack(0, nx, ny, nz, q.w(), q.x(), q.y(), q.z());
        double y = Turn.componentBack(1, nx, ny, nz, q.w(), q.x(), q.y(), q.z());
        double z = Turn.componentBack(2, nx, ny, nz, q.w(), q.x(), q.y(), q.z());
        return switch (volume) {
            case Sphere sphere -> along + sphere.radius();
            case Capsule capsule -> along + capsule.length() / 2 * Math.abs(x) + capsule.radius();
            case Box box ->
                    along
                            + (box.size().x() * Math.abs(x)
                                            + box.size().y() * Math.abs(y)
                                            + box.size().z() * Math.abs(z))
                                    / 2;
            default -> throw new IllegalStateException(volume + " is no part");
        };
    }
}
