package org.auvsim.core.volume;

import org.auvsim.core.math.Vec3;

/** Where a box rests on a face of another: the part of its own face that lies in the other. */
final class FaceManifold {
    /** Corners this close above the face count as touching; a share of the boxes' size. */
    private static final double SLACK = 1e-6;

    private FaceManifold() {}

    /**
     * The middle of the contact, halfway between the two surfaces.
     *
     * @param base the box whose face is met
     * @param axis the axis of that face, 0 to 2
     * @param outward the face's normal, out of the base
     * @param resting the box that meets it, with the face that looks most against the normal
     */
    static Vec3 middle(OrientedBox base, int axis, Vec3 outward, OrientedBox resting) {
        Vec3 down = outward.negated();
        ConvexPolygon touching = new ConvexPolygon(resting.face(down));
        for (int k = 1; k < 3; k++) {
            Vec3 side = base.axis((axis + k) % 3);
            double along = base.centre().dot(side);
            double half = base.half((axis + k) % 3);
            touching = touching.clipped(side, along + half);
            touching = touching.clipped(side.negated(), half - along);
        }
        double surface = base.centre().dot(outward) + base.half(axis);
        if (touching.isEmpty()) {
            return halfway(onFace(base, axis, resting.corner(down)), outward, surface);
        }
        double lowest = touching.corners().stream().mapToDouble(outward::dot).min().orElseThrow();
        double slack = SLACK * (base.half().norm() + resting.half().norm());
        touching = touching.clipped(outward, Math.max(surface, lowest) + slack);
        return halfway(touching.centroid(), outward, surface);
    }

    /** The point moved sideways until it is above or below the face. */
    private static Vec3 onFace(OrientedBox base, int axis, Vec3 point) {
        Vec3 moved = point;
        for (int k = 1; k < 3; k++) {
            Vec3 side = base.axis((axis + k) % 3);
            double half = base.half((axis + k) % 3);
            double along = moved.minus(base.centre()).dot(side);
            moved = moved.plus(side.times(Math.clamp(along, -half, half) - along));
        }
        return moved;
    }

    private static Vec3 halfway(Vec3 point, Vec3 outward, double surface) {
        return point.minus(outward.times((point.dot(outward) - surface) / 2));
    }
}
