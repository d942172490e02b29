package org.auvsim.core.effect;

import org.auvsim.core.entity.Block;
import org.auvsim.core.entity.BlockEffect;

/** The weights of all bodies of a world; a body without has an acceleration of zero. */
record GravityBlock(double[] downward) implements BlockEffect {
    @Override
    public void add(Block b) {
        double[] mass = b.mass;
        double[] acceleration = b.scratch[0];
        double[] fz = b.fz;
        b.gather(downward, acceleration);
        for (int i = 0; i < b.count; i++) {
            fz[i] -= mass[i] * acceleration[i];
        }
    }

    @Override
    public boolean mayTurn() {
        return false;
    }
}
