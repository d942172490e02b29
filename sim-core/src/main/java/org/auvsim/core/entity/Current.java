package org.auvsim.core.entity;

import org.auvsim.core.math.Vec3;

/**
 * A field of water velocity (m/s, world frame); the currents of a world add up. Where the water
 * moves unevenly or in time, its acceleration acts on bodies, too (Auton, Hunt &amp; Prud'homme
 * 1988).
 */
public interface Current extends Field<Vec3> {
    /** Whether the water's velocity ever differs from place to place or from time to time. */
    default boolean isUneven() {
        return true;
    }

    /**
     * The same current with what follows from its parameters alone worked out beforehand: what a
     * world evaluates, many times over. One that has nothing to work out is that itself.
     */
    default Current prepared() {
        return this;
    }

    /**
     * What the body in a slot feels of it at a place (m, world) and a time (s): its velocity there
     * (m/s, world), unless it moves but some bodies.
     */
    default Vec3 feltBy(int slot, Vec3 position, double time) {
        return valueAt(position, time);
    }

    /** By how much (m) it raises the water's surface over a place (m, world) at a time (s). */
    default double elevation(double x, double y, double time) {
        return 0;
    }

    /**
     * Adds its velocity to {@link Block#ux} to {@link Block#uz} and its elevation to {@link
     * Block#elevation} of all bodies of the block and, if it is uneven, its derivatives to {@link
     * Block#flow}. This one asks for the values and takes differences of them; a current that knows
     * its derivatives is exact and several times faster.
     */
    default void addTo(Block block) {
        for (int i = 0; i < block.count; i++) {
            addTo(block, i);
        }
    }

    /** The same for body {@code i} of the block alone, by values and their differences. */
    default void addTo(Block block, int i) {
        Vec3 place = block.position(i);
        Vec3 u = valueAt(place, block.time);
        block.ux[i] += u.x();
        block.uy[i] += u.y();
        block.uz[i] += u.z();
        if (isUneven()) {
            block.elevation[i] += elevation(place.x(), place.y(), block.time);
            FlowDifferences.add(this, block, i, place);
        }
    }
}
