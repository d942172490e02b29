// SPDX-License-Identifier: GPL-2.0-or-later
package org.auvsim.osp.drawing;

import org.auvsim.core.volume.Pose;
import org.opensourcephysics.numerics.Quaternion;

/** Brings corners of a shape to where they are in a view. */
final class Turn {
    private final Quaternion quaternion = new Quaternion(1, 0, 0, 0);
    private final double[] middle = new double[3];

    void set(Pose pose, View view) {
        quaternion.setCoordinates(pose.qw, pose.qx, pose.qy, pose.qz);
        middle[0] = pose.x - view.origin(0);
        middle[1] = pose.y - view.origin(1);
        middle[2] = pose.z - view.origin(2);
    }

    /** Where the origin of the shape is in the view; its own array. */
    double[] middle() {
        return middle;
    }

    /** A corner of the shape, stretched along its axes. */
    double[] corner(double[] of, double x, double y, double z) {
        double[] corner = {of[0] * x, of[1] * y, of[2] * z};
        quaternion.direct(corner);
        corner[0] += middle[0];
        corner[1] += middle[1];
        corner[2] += middle[2];
        return corner;
    }
}
