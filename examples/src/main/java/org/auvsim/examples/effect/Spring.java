package org.auvsim.examples.effect;

import org.auvsim.core.description.Unit;
import org.auvsim.core.entity.Block;
import org.auvsim.core.entity.BodyEffect;
import org.auvsim.core.math.Vec3;

/**
 * A spring without length that pulls its body's origin to a point: F = k (anchor - position).
 *
 * @param anchor (m, world)
 * @param stiffness k (N/m)
 */
public record Spring(@Unit("m") Vec3 anchor, @Unit("N/m") double stiffness) implements BodyEffect {
    @Override
    public void add(Block block, int i) {
        block.addForce(i, anchor.minus(block.position(i)).times(stiffness));
    }
}
