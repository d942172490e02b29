package org.auvsim.core.step;

import org.auvsim.core.entity.Block;
import org.auvsim.core.entity.BodyEffect;
import org.auvsim.core.math.Vec3;

/** A smooth force: toward a point (m, world), growing with the distance by a stiffness (N/m). */
record Spring(Vec3 end, double stiffness) implements BodyEffect {
    @Override
    public void add(Block block, int i) {
        block.addForce(i, end.minus(block.position(i)).times(stiffness));
    }
}
