package org.auvsim.core.effect;

import org.auvsim.core.entity.BlockEffect;

/**
 * Forces that depend on where bodies are alone, not on how they are turned or move. One at a centre
 * of mass beside the origin does turn its body, but such bodies are not spared anyway.
 */
interface PlainForce extends BlockEffect {
    @Override
    default boolean mayTurn() {
        return false;
    }

    @Override
    default boolean readsOrientation() {
        return false;
    }

    @Override
    default boolean mayBeStiff() {
        return false;
    }
}
