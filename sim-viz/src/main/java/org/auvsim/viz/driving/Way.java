package org.auvsim.viz.driving;

import org.auvsim.core.math.Vec3;
import org.auvsim.viz.scene.Movement;

/** Whether an object goes astern through the water; while it hardly moves, as it went before. */
public final class Way {
    /** Slower than this (m/s) an object hardly moves. */
    static final double CREEP = 0.05;

    private boolean isAstern;

    /** One of an object that goes ahead. */
    public Way() {}

    /** The object moves like this, in water of a velocity (m/s, world). */
    public void see(Movement motion, Vec3 water) {
        double surge = motion.orientation().rotateInverse(motion.velocity().minus(water)).x();
        if (Math.abs(surge) > CREEP) {
            isAstern = surge < 0;
        }
    }

    /** Whether it goes astern. */
    public boolean isAstern() {
        return isAstern;
    }
}
