package org.auvsim.core.dynamics;

import org.auvsim.core.entity.Actuator;
import org.auvsim.core.entity.Block;
import org.auvsim.core.entity.BlockEffect;
import org.auvsim.core.entity.BodyState;
import org.auvsim.core.entity.CoupledEffect;
import org.auvsim.core.entity.Effect;
import org.auvsim.core.entity.RigidBody;
import org.auvsim.core.entity.Surroundings;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.HashSet;
import java.util.List;
import java.util.Set;

/**
 * Evaluates one effect or actuator of one body as if nothing else acted on the bodies of a block.
 */
final class EffectAlone {
    private final int bodies;
    private final Block block;
    private final Surroundings around;
    private final Set<Long> ids = new HashSet<>();

    /**
     * In the present state of the bodies of a block, some of these.
     *
     * @param around what their effects were laid out with
     */
    EffectAlone(List<? extends RigidBody> bySlot, Surroundings around, Block block) {
        this.bodies = bySlot.size();
        this.around = around;
        this.block = block;
        bySlot.forEach(body -> ids.add(body.id()));
    }

    /**
     * Sets the block's forces and torques to those of an effect of the body in a slot.
     *
     * @return false, and nothing is set, for an effect that has ended as a partner has left
     */
    boolean evaluate(Effect effect, int owner) {
        if (effect instanceof CoupledEffect coupled && !ids.containsAll(coupled.partners())) {
            return false;
        }
        clear();
        layOut(effect, owner).add(block);
        return true;
    }

    /** Sets the block's forces and torques to those of an actuator of its body {@code i}. */
    void evaluate(Actuator actuator, int i) {
        clear();
        actuator.add(block, i);
    }

    private void clear() {
        for (int c = BodyState.PX; c <= BodyState.LZ; c++) {
            Arrays.fill(block.rate[c], 0, block.count, 0);
        }
    }

    private BlockEffect layOut(Effect effect, int owner) {
        List<List<Effect>> alone = new ArrayList<>(Collections.nCopies(bodies, List.of()));
        alone.set(owner, List.of(effect));
        return effect.layOut(alone, around);
    }

    /** Whether the forces and torques that the block now has are finite. */
    boolean areForcesFinite() {
        boolean finite = true;
        for (int c = BodyState.PX; c <= BodyState.LZ; c++) {
            for (int i = 0; i < block.count; i++) {
                finite &= Double.isFinite(block.rate[c][i]);
            }
        }
        return finite;
    }

    /** The largest component (N, N m) of what now acts on the block's first body. */
    double sizeOnFirst() {
        double size = 0;
        for (int c = BodyState.PX; c <= BodyState.LZ; c++) {
            size = Math.max(size, Math.abs(block.rate[c][0]));
        }
        return size;
    }
}
