package org.auvsim.core.step;

import org.auvsim.core.volume.Pose;

/** The smallest sphere that holds a sphere at two instants (thesis, section 5.1.2). */
final class SweptSphere {
    private SweptSphere() {}

    /** Writes x, y, z, radius of the one about two spheres, which may differ in size. */
    static void write(Pose from, double r0, Pose to, double r1, double[] target, int at) {
        double distance = distance(from, to);
        if (distance + Math.min(r0, r1) <= Math.max(r0, r1)) {
            Pose larger = r0 >= r1 ? from : to;
            target[at] = larger.x;
            target[at + 1] = larger.y;
            target[at + 2] = larger.z;
            target[at + 3] = Math.max(r0, r1);
            return;
        }
        double radius = (distance + r0 + r1) / 2;
        double share = (radius - r0) / distance;
        target[at] = from.x + share * (to.x - from.x);
        target[at + 1] = from.y + share * (to.y - from.y);
        target[at + 2] = from.z + share * (to.z - from.z);
        target[at + 3] = radius;
    }

    static double distance(Pose from, Pose to) {
        double dx = to.x - from.x;
        double dy = to.y - from.y;
        double dz = to.z - from.z;
        return Math.sqrt(dx * dx + dy * dy + dz * dz);
    }
}
