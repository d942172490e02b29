package org.auvsim.examples.scala;

import org.auvsim.core.description.Unit;
import org.auvsim.core.entity.Block;
import org.auvsim.core.entity.BodyEffect;
import org.auvsim.core.math.Vec3;

/**
 * A bungee, a spring and a dashpot side by side: the face that scenarios see, a record, of what
 * {@link BungeeForce} is in Scala.
 *
 * @param anchor (m, world)
 * @param stiffness (N/m)
 * @param damping (N s/m)
 */
public record Bungee(
        @Unit("m") Vec3 anchor, @Unit("N/m") double stiffness, @Unit("N s/m") double damping)
        implements BodyEffect {
    @Override
    public void add(Block block, int i) {
        block.addForce(
                i,
                BungeeForce.on(anchor, stiffness, damping, block.position(i), block.velocity(i)));
    }
}
