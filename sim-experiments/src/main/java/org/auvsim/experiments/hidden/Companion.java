package org.auvsim.experiments.hidden;

import org.apache.commons.math3.geometry.euclidean.threed.Vector3D;

import java.util.List;

/**
 * What goes along with a body through one run and has a state or a will of its own: a mass that
 * sloshes in it, kicks that hit it, the wake that it left.
 */
interface Companion {
    /** A change of momentum (N s, world axes) at a time (s). */
    record Kick(double at, Vector3D impulse) {}

    /** What it is at the beginning. */
    default double[] start(Instant at) {
        return new double[0];
    }

    /** How what it is changes (per s). */
    default double[] slopes(Instant at, double[] own) {
        return own;
    }

    /** What it does to the body. */
    default Wrench on(Instant at, double[] own) {
        return Wrench.NONE;
    }

    default List<Kick> kicks() {
        return List.of();
    }

    /** Is told now and then how the body moves, in order of time. */
    default void remember(Instant at) {
        // most forget at once
    }
}
