package org.auvsim.core.entity;

import java.util.List;

/**
 * Something that exerts force and torque on a rigid body while it moves: gravity, drag, lift.
 *
 * <p>An effect is an immutable value with its parameters. The world lays out all effects of one
 * class over its bodies once, when bodies or effects change, and then calls the layout for blocks
 * of bodies. {@link BodyEffect} is the easy form for one body at a time.
 */
public interface Effect {
    /**
     * Arranges effects of this one's class for fast evaluation.
     *
     * @param bySlot the effects of this class of the body in each slot, most often none or one
     * @param around the world's fields and who is where; a layout is made anew when they change
     */
    BlockEffect layOut(List<List<Effect>> bySlot, Surroundings around);

    /**
     * Whether it ties the body to a place of the world or to other bodies, and so is no property of
     * the body alone: who tries a body elsewhere leaves it out.
     */
    default boolean dependsOnPlace() {
        return false;
    }

    /**
     * Whether what it exerts comes or goes within moments, as a blow: who compares motions in
     * longer steps than the world's would miss it.
     */
    default boolean isAbrupt() {
        return false;
    }
}
