package org.auvsim.core.step;

import org.auvsim.core.entity.Block;

import java.util.Arrays;

/**
 * The constant forces (N) and torques (N m, world) that contacts exert on bodies for the rest of a
 * frame; by slot.
 */
final class ContactForces {
    private final double[] force;
    private final boolean[] isPushed;
    private boolean anyPushed;

    ContactForces(int bodies) {
        force = new double[6 * bodies];
        isPushed = new boolean[bodies];
    }

    /** Takes all forces away. */
    void clear() {
        if (anyPushed) {
            Arrays.fill(isPushed, false);
            anyPushed = false;
        }
    }

    /** Sets what acts on a body: force, then torque, from {@code from} on. */
    void set(int slot, double[] forceAndTorque, int from) {
        System.arraycopy(forceAndTorque, from, force, 6 * slot, 6);
        isPushed[slot] = true;
        anyPushed = true;
    }

    void clear(int slot) {
        isPushed[slot] = false;
    }

    /** A component (N) of the force on a body. */
    double along(int slot, int axis) {
        return isPushed[slot] ? force[6 * slot + axis] : 0;
    }

    /** Lets the forces act on the bodies of a block. */
    void push(Block block) {
        if (!anyPushed) {
            return;
        }
        block.hasContactForces = true;
        boolean turns = false;
        for (int i = 0; i < block.count; i++) {
            int at = 6 * block.slot(i);
            double share = isPushed[block.slot(i)] ? 1 : 0;
            block.contactFx[i] = share * force[at];
            block.contactFy[i] = share * force[at + 1];
            block.contactFz[i] = share * force[at + 2];
            block.contactTx[i] = share * force[at + 3];
            block.contactTy[i] = share * force[at + 4];
            block.contactTz[i] = share * force[at + 5];
            turns |= block.contactTx[i] != 0 || block.contactTy[i] != 0 || block.contactTz[i] != 0;
        }
        block.hasContactTorques = turns;
    }
}
