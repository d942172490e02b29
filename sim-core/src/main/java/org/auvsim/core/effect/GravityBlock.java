package org.auvsim.core.effect;

import org.auvsim.core.entity.Block;
import org.auvsim.core.entity.SpatialInertia;
import org.auvsim.core.math.Vec3;

/** The weights of all bodies of a world; a body without has an acceleration of zero. */
final class GravityBlock implements PlainForce {
    private final double[] downward;

    /** With these accelerations (m/s^2), by slot. */
    GravityBlock(double[] downward) {
        this.downward = downward;
    }

    @Override
    public void add(Block b) {
        double[] mass = b.mass;
        double[] acceleration = b.scratch[0];
        double[] fz = b.fz;
        b.gather(downward, acceleration);
        for (int i = 0; i < b.count; i++) {
            fz[i] -= mass[i] * acceleration[i];
        }
        for (int i = 0; b.hasSpatial && i < b.count; i++) {
            SpatialInertia spatial = b.inertia(i);
            if (spatial != null) {
                turn(b, i, b.toWorld(i, spatial.centreOfMass()), mass[i] * acceleration[i]);
            }
        }
    }

    /** A weight (N) at a point (m from the origin, world axes). */
    private static void turn(Block b, int i, Vec3 point, double weight) {
        b.tx[i] -= point.y() * weight;
        b.ty[i] += point.x() * weight;
    }
}
