package org.auvsim.core.entity;

import org.auvsim.core.description.Default;
import org.auvsim.core.math.Vec3;

import java.util.ArrayList;
import java.util.List;

/**
 * Held in some directions of the world, as by the carriage of a towing tank.
 *
 * @param x whether its origin cannot move along x
 * @param y likewise
 * @param z likewise
 * @param turnX whether it cannot turn about x
 * @param turnY likewise
 * @param turnZ likewise
 */
public record Held(
        @Default("0") boolean x,
        @Default("0") boolean y,
        @Default("0") boolean z,
        @Default("0") boolean turnX,
        @Default("0") boolean turnY,
        @Default("0") boolean turnZ)
        implements Mount {
    /** The axes of the world. */
    static final List<Vec3> AXES = List.of(new Vec3(1, 0, 0), new Vec3(0, 1, 0), new Vec3(0, 0, 1));

    @Override
    public List<Vec3> freeTranslations() {
        return free(x, y, z);
    }

    @Override
    public List<Vec3> freeRotations() {
        return free(turnX, turnY, turnZ);
    }

    private static List<Vec3> free(boolean... held) {
        List<Vec3> free = new ArrayList<>();
        for (int axis = 0; axis < 3; axis++) {
            if (!held[axis]) {
                free.add(AXES.get(axis));
            }
        }
        return free;
    }
}
