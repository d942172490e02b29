package org.auvsim.cli.mirror;

import org.auvsim.core.math.Vec3;

/** Takes each comparison of an object's two positions. */
@FunctionalInterface
public interface Comparisons {
    /**
     * An object was compared.
     *
     * @param time of the world (s)
     * @param served where the server has it (m)
     * @param mirrored where the mirror has it (m)
     */
    void compared(double time, String name, Vec3 served, Vec3 mirrored);
}
