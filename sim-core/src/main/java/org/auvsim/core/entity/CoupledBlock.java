package org.auvsim.core.entity;

import java.util.ArrayList;
import java.util.List;

/** Coupled effects of one class over all bodies; a block that lacks a partner is passed over. */
final class CoupledBlock implements BlockEffect {
    private final CoupledEffect[][] effects;

    /** Slots of the partners of each body's effects. */
    private final int[][][] partners;

    CoupledBlock(List<List<Effect>> bySlot, Surroundings around) {
        effects = new CoupledEffect[bySlot.size()][];
        partners = new int[bySlot.size()][][];
        for (int slot = 0; slot < effects.length; slot++) {
            effects[slot] = bySlot.get(slot).toArray(CoupledEffect[]::new);
            partners[slot] = new int[effects[slot].length][];
            for (int k = 0; k < effects[slot].length; k++) {
                partners[slot][k] =
                        effects[slot][k].partners().stream().mapToInt(around::slotOf).toArray();
            }
        }
    }

    @Override
    public void add(Block block) {
        for (int i = 0; i < block.count; i++) {
            int slot = block.slot(i);
            for (int k = 0; k < effects[slot].length; k++) {
                int[] found = block.find(partners[slot][k]);
                if (found.length > 0) {
                    effects[slot][k].add(block, i, found);
                }
            }
        }
    }

    @Override
    public List<int[]> couples() {
        List<int[]> couples = new ArrayList<>();
        for (int slot = 0; slot < partners.length; slot++) {
            for (int[] others : partners[slot]) {
                int[] couple = new int[others.length + 1];
                couple[0] = slot;
                System.arraycopy(others, 0, couple, 1, others.length);
                couples.add(couple);
            }
        }
        return couples;
    }
}
