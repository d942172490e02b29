package org.auvsim.core.effect;

import org.auvsim.core.description.Default;
import org.auvsim.core.description.Unit;
import org.auvsim.core.entity.Block;
import org.auvsim.core.entity.BodyEffect;
import org.auvsim.core.entity.Domain;
import org.auvsim.core.math.Vec3;

/**
 * An elastic line from a point of the body to a fixed point of the world. It has no weight and no
 * drag, and pulls only: its tension is max(0, k (d - length) + c d') at a distance d beyond its
 * length, else 0.
 *
 * <p>Evaluated body by body: few have one, and those that do are scattered.
 *
 * @param anchor the world's point (m, world)
 * @param point the body's point (m, body)
 * @param length up to which it is slack (m), 0 or more
 * @param stiffness k (N/m), above 0
 * @param damping c (N s/m), 0 or more
 */
public record Mooring(
        @Unit("m") Vec3 anchor,
        @Unit("m") @Default("0 0 0") Vec3 point,
        @Unit("m") double length,
        @Unit("N/m") double stiffness,
        @Unit("N s/m") @Default("0.0") double damping)
        implements BodyEffect {
    /**
     * A checked mooring.
     *
     * @throws IllegalArgumentException if a number is not finite or below what it may be
     */
    public Mooring {
        Domain.finite("a mooring", "anchor", anchor, "m");
        Domain.finite("a mooring", "point", point, "m");
        Line.requireValid("a mooring", length, stiffness, damping);
    }

    @Override
    public boolean dependsOnPlace() {
        return true;
    }

    @Override
    public void add(Block block, int i) {
        Vec3 arm = block.toWorld(i, point);
        Vec3 way = anchor.minus(block.position(i).plus(arm));
        Vec3 velocity = block.velocity(i).plus(block.angularVelocity(i).cross(arm));
        Vec3 pull = Line.pull(way, velocity.negated(), length, stiffness, damping);
        block.addForce(i, pull);
        block.addTorque(i, arm.cross(pull));
    }
}
