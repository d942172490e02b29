package org.auvsim.core.entity;

import java.util.List;

/** Effects of one class, laid out over all bodies of a world. */
public interface BlockEffect {
    /**
     * Adds to the force and torque of bodies of the block; reads anything else of it, changes
     * nothing else, and allocates nothing.
     */
    void add(Block block);

    /** Whether it ever adds a torque; only one that says no spares bodies that do not turn work. */
    default boolean mayTurn() {
        return true;
    }

    /** Whether it reads the orientations of bodies that do not turn; only a no spares them. */
    default boolean readsOrientation() {
        return true;
    }

    /**
     * Whether it ever depends on how a body moves, so that a time step may be too long for it; only
     * where one says yes is it looked after.
     */
    default boolean mayBeStiff() {
        return true;
    }

    /** Slots of bodies that have to be in one block as it couples them: an array for each time. */
    default List<int[]> couples() {
        return List.of();
    }
}
