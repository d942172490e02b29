package org.auvsim.core.effect;

import org.auvsim.core.description.Default;
import org.auvsim.core.description.Unit;
import org.auvsim.core.entity.Block;
import org.auvsim.core.entity.CoupledEffect;
import org.auvsim.core.entity.Domain;
import org.auvsim.core.math.Vec3;

import java.util.List;

/**
 * An elastic line from a point of the body to a point of another one, which pulls on both. It has
 * no weight and no drag, and pulls only: its tension is max(0, k (d - length) + c d') at a distance
 * d beyond its length, else 0.
 *
 * @param to the id of the other body
 * @param point of the body that has the tether (m, body)
 * @param toPoint of the other body (m, that body)
 * @param length up to which it is slack (m), 0 or more
 * @param stiffness k (N/m), above 0
 * @param damping c (N s/m), 0 or more
 */
public record Tether(
        long to,
        @Unit("m") @Default("0 0 0") Vec3 point,
        @Unit("m") @Default("0 0 0") Vec3 toPoint,
        @Unit("m") double length,
        @Unit("N/m") double stiffness,
        @Unit("N s/m") @Default("0.0") double damping)
        implements CoupledEffect {
    /**
     * A checked tether.
     *
     * @throws IllegalArgumentException if a number is not finite or below what it may be
     */
    public Tether {
        Domain.finite("a tether", "point", point, "m");
        Domain.finite("a tether", "other body's point", toPoint, "m");
        Line.requireValid("a tether", length, stiffness, damping);
    }

    @Override
    public List<Long> partners() {
        return List.of(to);
    }

    @Override
    public void add(Block block, int i, int[] partners) {
        int other = partners[0];
        Vec3 arm = block.toWorld(i, point);
        Vec3 otherArm = block.toWorld(other, toPoint);
        Vec3 way = block.position(other).plus(otherArm).minus(block.position(i).plus(arm));
        Vec3 velocity = velocityAt(block, other, otherArm).minus(velocityAt(block, i, arm));
        Vec3 pull = Line.pull(way, velocity, length, stiffness, damping);
        block.addForce(i, pull);
        block.addTorque(i, arm.cross(pull));
        block.addForce(other, pull.negated());
        block.addTorque(other, otherArm.cross(pull.negated()));
    }

    private static Vec3 velocityAt(Block block, int i, Vec3 arm) {
        return block.velocity(i).plus(block.angularVelocity(i).cross(arm));
    }
}
