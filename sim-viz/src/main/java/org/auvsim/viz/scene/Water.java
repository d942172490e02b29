package org.auvsim.viz.scene;

import org.auvsim.core.entity.Current;
import org.auvsim.core.entity.Field;
import org.auvsim.core.math.Vec3;

import java.util.ArrayList;
import java.util.List;

/** How the water moves: all currents of a world together. */
public final class Water {
    /** That of a world without currents. */
    public static final Water STILL = new Water(List.of());

    private final List<Current> currents;

    private Water(List<Current> currents) {
        this.currents = currents;
    }

    static Water of(List<Field<?>> fields) {
        List<Current> found = new ArrayList<>();
        for (Field<?> field : fields) {
            if (field instanceof Current current) {
                found.add(current.prepared());
            }
        }
        return new Water(List.copyOf(found));
    }

    /** Whether nothing moves it. */
    public boolean isStill() {
        return currents.isEmpty();
    }

    /** Its velocity (m/s, world) at a place (m, world) and a time (s). */
    public Vec3 velocity(Vec3 place, double time) {
        Vec3 sum = Vec3.ZERO;
        for (Current current : currents) {
            sum = sum.plus(current.valueAt(place, time));
        }
        return sum;
    }

    /** By how much its surface is raised (m) over a place (m, world) at a time (s). */
    public double elevation(double x, double y, double time) {
        double sum = 0;
        for (int k = 0; k < currents.size(); k++) {
            sum += currents.get(k).elevation(x, y, time);
        }
        return sum;
    }
}
