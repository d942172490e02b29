package org.auvsim.core.dynamics;

import static org.auvsim.core.entity.BodyState.LX;
import static org.auvsim.core.entity.BodyState.LZ;
import static org.auvsim.core.entity.BodyState.PX;
import static org.auvsim.core.entity.BodyState.PY;
import static org.auvsim.core.entity.BodyState.PZ;
import static org.auvsim.core.entity.BodyState.QW;
import static org.auvsim.core.entity.BodyState.QZ;

import org.auvsim.core.entity.Block;
import org.auvsim.core.entity.BlockEffect;
import org.auvsim.core.entity.BodyState;
import org.auvsim.core.entity.Current;
import org.auvsim.core.entity.SpatialInertia;
import org.auvsim.core.math.Vec3;

import java.util.Arrays;
import java.util.List;

/**
 * The rigid-body equations in momenta (thesis, Table 5.1; Witkin &amp; Baraff 1997):
 *
 * <pre>dS/dt = P/m    dq/dt = 1/2 [0, w] q    dP/dt = F    dL/dt = tau    w = R I^-1 R^T L</pre>
 *
 * <p>Those of a body whose origin is not its centre of mass, or that has added mass or a mount, are
 * in {@link SpatialInertia}.
 *
 * <p>One call evaluates a block of bodies. A block whose bodies neither turn nor meet anything that
 * may turn them is spared what has to do with it.
 */
public final class EquationsOfMotion {
    private final BodyState bodies;
    private final BlockEffect[] effects;
    private final Current[] currents;
    private final boolean isUneven;
    private final boolean effectsTurn;
    private final boolean effectsReadOrientation;
    private final boolean mayBeStiff;
    private final BodyGroups groups;

    /**
     * The equations for the bodies of a world, in the currents that there are now.
     *
     * @param effects what acts on them beside named forces and propulsors, in this order
     */
    public EquationsOfMotion(BodyState bodies, List<BlockEffect> effects) {
        this.bodies = bodies;
        this.effects = effects.toArray(BlockEffect[]::new);
        this.mayBeStiff = effects.stream().anyMatch(BlockEffect::mayBeStiff);
        this.effectsReadOrientation = effects.stream().anyMatch(BlockEffect::readsOrientation);
        this.effectsTurn = effects.stream().anyMatch(BlockEffect::mayTurn);
        this.groups = new BodyGroups(bodies, effects);
        this.currents = bodies.currents().toArray(Current[]::new);
        this.isUneven = bodies.currents().stream().anyMatch(Current::isUneven);
    }

    /** Which bodies have to be loaded into one block, as effects couple them. */
    public BodyGroups groups() {
        return groups;
    }

    /** Copies state and constants of {@code count} bodies from slot {@code first} on. */
    public void load(Block block, int first, int count, double time) {
        block.take(first, count);
        load(block, time);
    }

    /** Copies state and constants of the bodies in the first {@code count} of these slots. */
    public void load(Block block, int[] slots, int count, double time) {
        block.take(slots, count);
        load(block, time);
    }

    private void load(Block block, double time) {
        block.time = time;
        for (int c = 0; c < BodyState.COLUMNS; c++) {
            block.gather(bodies.column(c), block.state[c]);
        }
        bodies.loadMasses(block);
        bodies.applied().load(block);
        block.turning =
                effectsTurn
                        || block.hasSpatial
                        || spins(block)
                        || bodies.applied().turns(block)
                        || bodies.actuators().push(block);
        if (!block.turning) {
            keepOrientations(block);
        }
    }

    private static boolean spins(Block b) {
        long bits = 0;
        for (int c = LX; c <= LZ; c++) {
            double[] momentum = b.state[c];
            for (int i = 0; i < b.count; i++) {
                bits |= Double.doubleToRawLongBits(momentum[i]);
            }
        }
        return bits << 1 != 0;
    }

    /**
     * Prepares bodies that do not turn, so that the same bits come out as if it were integrated.
     */
    private void keepOrientations(Block b) {
        for (int c = LX; c <= LZ; c++) {
            Arrays.fill(b.state[c], 0, b.count, 0);
            Arrays.fill(b.rate[c], 0, b.count, 0);
        }
        for (int c = QW; c <= QZ; c++) {
            Arrays.fill(b.rate[c], 0, b.count, 0);
        }
        Arrays.fill(b.wx, 0, b.count, 0);
        Arrays.fill(b.wy, 0, b.count, 0);
        Arrays.fill(b.wz, 0, b.count, 0);
        if (effectsReadOrientation || bodies.applied().haveBodyForces()) {
            Rotation.matrices(b);
        }
    }

    /** Fills rotations, velocities, forces, torques and rates of the block from its state. */
    public void evaluate(Block b) {
        act(b);
        if (b.hasSpatial) {
            b.spatial().complete(b);
        }
        if (b.hasFixed) {
            holdFixed(b);
        }
    }

    /** As {@link #evaluate}, but forces and torques act as if nothing held the bodies. */
    void act(Block b) {
        b.moved();
        plainVelocities(b);
        waterVelocities(b);
        if (b.turns()) {
            turn(b, needsSpin());
        }
        if (b.hasSpatial) {
            b.spatial().carry(b);
        }
        bodies.applied().write(b);
        for (BlockEffect effect : effects) {
            effect.add(b);
        }
        bodies.actuators().add(b);
        if (b.hasFlow && b.hasSpatial) {
            meetFlow(b);
        }
        if (b.hasContactForces) {
            b.addContactForces();
        }
    }

    private static void meetFlow(Block b) {
        for (int i = 0; i < b.count; i++) {
            SpatialInertia spatial = b.inertia(i);
            if (spatial != null) {
                spatial.meetFlow(b, i);
            }
        }
    }

    /** Orientations and all that follows from them, angular velocities in the world if wanted. */
    private void turn(Block b, boolean inWorld) {
        Rotation.matrices(b);
        if (!b.hasSpatial || !b.spatial().areAllHere()) {
            if (!b.hasInertia) {
                bodies.loadInertia(b);
            }
            Rotation.bodyRates(b);
            if (inWorld) {
                b.toWorld(b.wx, b.wy, b.wz, b.bodyWx, b.bodyWy, b.bodyWz);
            }
        }
        if (b.hasSpatial) {
            b.spatial().move(b);
        }
        Rotation.quaternionRates(b);
    }

    /** Fills the angular velocities (world) of an evaluated block, which nobody may have needed. */
    public void spin(Block b) {
        if (b.turns() && !needsSpin()) {
            b.toWorld(b.wx, b.wy, b.wz, b.bodyWx, b.bodyWy, b.bodyWz);
        }
    }

    private boolean needsSpin() {
        return effects.length > 0 || !bodies.actuators().isEmpty();
    }

    /** Fills velocities and angular velocities (world) of the block from its state. */
    public void motions(Block b) {
        plainVelocities(b);
        if (b.hasSpatial) {
            waterVelocities(b);
        }
        if (b.turns()) {
            turn(b, true);
        }
    }

    /** Fills the velocities of the origins alone from the state of the block. */
    public void velocities(Block b) {
        plainVelocities(b);
        if (b.hasSpatial) {
            waterVelocities(b);
            Rotation.matrices(b);
            b.spatial().move(b);
        }
    }

    private static void plainVelocities(Block b) {
        double[] x = b.state[PX];
        double[] y = b.state[PY];
        double[] z = b.state[PZ];
        double[] by = b.inverseMass;
        for (int i = 0; i < b.count; i++) {
            b.vx[i] = x[i] * by[i];
            b.vy[i] = y[i] * by[i];
            b.vz[i] = z[i] * by[i];
        }
    }

    /** Velocity of the water (m/s, world) around the body in a slot at a place and a time (s). */
    Vec3 waterAround(int slot, Vec3 position, double time) {
        Vec3 sum = Vec3.ZERO;
        for (Current current : currents) {
            sum = sum.plus(current.feltBy(slot, position, time));
        }
        return sum;
    }

    /** Whether an effect may need shorter steps than those of the world. */
    public boolean mayBeStiff() {
        return mayBeStiff || !bodies.actuators().isEmpty();
    }

    /** Scales the quaternions of the block back to length 1; a zero comes out without its sign. */
    public void normalizeOrientations(Block b) {
        Rotation.normalize(b);
    }

    private void waterVelocities(Block b) {
        b.hasWater = currents.length > 0;
        b.hasFlow = isUneven;
        if (currents.length == 0) {
            return;
        }
        Arrays.fill(b.ux, 0, b.count, 0);
        Arrays.fill(b.uy, 0, b.count, 0);
        Arrays.fill(b.uz, 0, b.count, 0);
        if (isUneven) {
            Arrays.fill(b.elevation, 0, b.count, 0);
            for (double[] derivative : b.flow) {
                Arrays.fill(derivative, 0, b.count, 0);
            }
        }
        for (Current current : currents) {
            current.addTo(b);
        }
    }

    /** Whatever pushes a fixed body, its momenta stay zero. */
    private static void holdFixed(Block b) {
        for (int i = 0; i < b.count; i++) {
            if (b.inverseMass[i] == 0) {
                for (int c = PX; c <= LZ; c++) {
                    b.rate[c][i] = 0;
                }
            }
        }
    }
}
