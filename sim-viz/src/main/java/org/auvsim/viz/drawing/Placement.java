package org.auvsim.viz.drawing;

import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.volume.Pose;
import org.auvsim.viz.scene.ActorView;

/** A pose that is used again and again, and the ways to fill it. */
final class Placement {
    /** Below this cosine and a direction is straight back. */
    private static final double BACKWARD = -1 + 1e-12;

    final Pose pose = new Pose();

    /** An object's, as shown. */
    void of(ActorView actor) {
        pose.x = actor.position(0);
        pose.y = actor.position(1);
        pose.z = actor.position(2);
        pose.qw = actor.orientation(0);
        pose.qx = actor.orientation(1);
        pose.qy = actor.orientation(2);
        pose.qz = actor.orientation(3);
    }

    /** An object's, as projected. */
    void ofProjected(ActorView actor) {
        pose.x = actor.projectedPosition(0);
        pose.y = actor.projectedPosition(1);
        pose.z = actor.projectedPosition(2);
        pose.qw = actor.projectedOrientation(0);
        pose.qx = actor.projectedOrientation(1);
        pose.qy = actor.projectedOrientation(2);
        pose.qz = actor.projectedOrientation(3);
    }

    /** Upright at a place (m, world). */
    void at(double x, double y, double z) {
        pose.x = x;
        pose.y = y;
        pose.z = z;
        pose.qw = 1;
        pose.qx = 0;
        pose.qy = 0;
        pose.qz = 0;
    }

    /** Its x axis along a unit vector. */
    void pointing(double dx, double dy, double dz) {
        if (dx < BACKWARD) {
            turned(0, 0, 0, 1);
            return;
        }
        double norm = Math.sqrt((1 + dx) * (1 + dx) + dz * dz + dy * dy);
        turned((1 + dx) / norm, 0, -dz / norm, dy / norm);
    }

    private void turned(double w, double x, double y, double z) {
        pose.qw = w;
        pose.qx = x;
        pose.qy = y;
        pose.qz = z;
    }

    /** What is placed so in the coordinates of another one. */
    void within(Placement outer, Vec3 position, Quat orientation) {
        Pose o = outer.pose;
        pose.x = o.x + outer.world(0, position.x(), position.y(), position.z());
        pose.y = o.y + outer.world(1, position.x(), position.y(), position.z());
        pose.z = o.z + outer.world(2, position.x(), position.y(), position.z());
        Quat i = orientation;
        turned(
                o.qw * i.w() - o.qx * i.x() - o.qy * i.y() - o.qz * i.z(),
                o.qw * i.x() + o.qx * i.w() + o.qy * i.z() - o.qz * i.y(),
                o.qw * i.y() - o.qx * i.z() + o.qy * i.w() + o.qz * i.x(),
                o.qw * i.z() + o.qx * i.y() - o.qy * i.x() + o.qz * i.w());
    }

    /** Component {@code axis}, along the world's axes, of a vector along the pose's. */
    double world(int axis, double x, double y, double z) {
        double w = pose.qw;
        double a = pose.qx;
        double b = pose.qy;
        double c = pose.qz;
        return switch (axis) {
            case 0 ->
                    (1 - 2 * (b * b + c * c)) * x
                            + 2 * (a * b - w * c) * y
                            + 2 * (a * c + w * b) * z;
            case 1 ->
                    2 * (a * b + w * c) * x
                            + (1 - 2 * (a * a + c * c)) * y
                            + 2 * (b * c - w * a) * z;
            default ->
                    2 * (a * c - w * b) * x
                            + 2 * (b * c + w * a) * y
                            + (1 - 2 * (a * a + b * b)) * z;
        };
    }
}
