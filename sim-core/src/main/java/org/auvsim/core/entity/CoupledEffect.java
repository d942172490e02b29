package org.auvsim.core.entity;

import java.util.List;

/**
 * An effect that depends on more bodies than its own, or acts on them: a tether, a spring between
 * two. Bodies that it couples are always integrated together, and moved together when one of them
 * collides. A fixed partner takes part but joins nothing: what is moored to the same ground is not
 * coupled by it.
 *
 * <p>The effect belongs to one of the bodies and names the others by id. They have to be in the
 * world when its body enters; when one of them leaves, the effect ends.
 */
public interface CoupledEffect extends Effect {
    /** The ids of the other bodies, none of them twice; one or more. */
    List<Long> partners();

    /**
     * Adds this effect's forces and torques to body {@code i} of the block and to its partners,
     * with {@link Block#addForce} and {@link Block#addTorque}.
     *
     * @param partners where the partners are in the block: one for each of {@link #partners()}, in
     *     that order; what is behind them has no meaning
     */
    void add(Block block, int i, int[] partners);

    @Override
    default boolean dependsOnPlace() {
        return true;
    }

    @Override
    default BlockEffect layOut(List<List<Effect>> bySlot, Surroundings around) {
        return new CoupledBlock(bySlot, around);
    }
}
