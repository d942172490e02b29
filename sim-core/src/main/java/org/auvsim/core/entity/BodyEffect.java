package org.auvsim.core.entity;

import java.util.List;

/**
 * An effect given for one body at a time: the easy form for an effect of a user's own, about three
 * times slower than one that is written for blocks.
 */
public interface BodyEffect extends Effect {
    /**
     * Adds this effect's force and torque on body {@code i} of the block with {@link
     * Block#addForce} and {@link Block#addTorque}.
     */
    void add(Block block, int i);

    @Override
    default BlockEffect layOut(List<List<Effect>> bySlot, Surroundings around) {
        BodyEffect[][] effects = new BodyEffect[bySlot.size()][];
        for (int slot = 0; slot < effects.length; slot++) {
            effects[slot] = bySlot.get(slot).toArray(BodyEffect[]::new);
        }
        return block -> {
            for (int i = 0; i < block.count; i++) {
                for (BodyEffect effect : effects[block.slot(i)]) {
                    effect.add(block, i);
                }
            }
        };
    }
}
