package org.auvsim.core.dynamics;

import org.auvsim.core.entity.Block;
import org.auvsim.core.entity.BodyState;
import org.auvsim.core.entity.MountReaction;
import org.auvsim.core.entity.SpatialInertia;
import org.auvsim.core.entity.Wrench;
import org.auvsim.core.math.Vec3;

/** What holds bodies that are fixed or on a mount, at their present states. */
public final class ConstraintForce {
    /** The time (s) over which the change of the water's velocity is taken. */
    private static final double WATER_CHANGE = 1e-4;

    private final EquationsOfMotion equations;
    private final BodyState bodies;

    /** Of bodies among these. */
    public ConstraintForce(EquationsOfMotion equations, BodyState bodies) {
        this.equations = equations;
        this.bodies = bodies;
    }

    /** The one on the body in a slot at a time (s); zero for a body that is free. */
    public Wrench on(int slot, double time) {
        SpatialInertia inertia = bodies.spatial(slot);
        boolean isFixed = bodies.inverseMass()[slot] == 0;
        if (!isFixed && inertia == null) {
            return Wrench.ZERO;
        }
        int[] together = equations.groups().companions(slot);
        Block block = new Block(together.length);
        equations.load(block, together, together.length, time);
        equations.act(block);
        int i = block.indexOf(slot);
        if (isFixed || inertia == null) {
            return new Wrench(
                    new Vec3(block.fx[i], block.fy[i], block.fz[i]).times(-1),
                    new Vec3(block.tx[i], block.ty[i], block.tz[i]).times(-1));
        }
        return MountReaction.of(block, i, inertia, waterAcceleration(block, i));
    }

    /** Of the water that the origin meets on its way, by central difference. */
    private Vec3 waterAcceleration(Block block, int i) {
        Vec3 half = block.velocity(i).times(WATER_CHANGE / 2);
        Vec3 after =
                equations.waterAround(
                        block.slot(i), block.position(i).plus(half), block.time + WATER_CHANGE / 2);
        Vec3 before =
                equations.waterAround(
                        block.slot(i),
                        block.position(i).minus(half),
                        block.time - WATER_CHANGE / 2);
        return after.minus(before).times(1 / WATER_CHANGE);
    }
}
