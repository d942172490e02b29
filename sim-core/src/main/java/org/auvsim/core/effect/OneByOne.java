package org.auvsim.core.effect;

import org.auvsim.core.entity.Block;
import org.auvsim.core.entity.Effect;

import java.util.List;

/**
 * Forces of effects that few bodies have, each evaluated for itself: at a body that has none this
 * costs a look.
 */
final class OneByOne implements PlainForce {
    private static final Effect[] NONE = {};

    private final Effect[][] bySlot;
    private final Push push;
    private final boolean isStiff;

    /** Adds the force of an effect on body {@code i} of the block. */
    interface Push {
        void add(Effect effect, Block block, int i);
    }

    private OneByOne(List<List<Effect>> effects, boolean isStiff, Push push) {
        bySlot = new Effect[effects.size()][];
        for (int slot = 0; slot < bySlot.length; slot++) {
            List<Effect> own = effects.get(slot);
            bySlot[slot] = own.isEmpty() ? NONE : own.toArray(Effect[]::new);
        }
        this.isStiff = isStiff;
        this.push = push;
    }

    /** Those that depend on time alone, or on slowly varying fields of place. */
    static OneByOne mild(List<List<Effect>> bySlot, Push push) {
        return new OneByOne(bySlot, false, push);
    }

    /** Those that may be too much for a time step. */
    static OneByOne stiff(List<List<Effect>> bySlot, Push push) {
        return new OneByOne(bySlot, true, push);
    }

    @Override
    public void add(Block block) {
        for (int i = 0; i < block.count; i++) {
            for (Effect effect : bySlot[block.slot(i)]) {
                push.add(effect, block, i);
            }
        }
    }

    @Override
    public boolean mayBeStiff() {
        return isStiff;
    }
}
