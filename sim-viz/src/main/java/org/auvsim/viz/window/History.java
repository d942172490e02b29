package org.auvsim.viz.window;

import org.auvsim.core.math.Vec3;
import org.auvsim.viz.scene.Movement;

/**
 * How an object moved over the last minute of the world's time; never more than it has room for.
 */
final class History {
    /** x, y, z, depth (m), speed (m/s), yaw (degrees). */
    static final int QUANTITIES = 6;

    static final double SECONDS = 60;
    private static final int ROOM = 600;

    private final double[] times = new double[ROOM];
    private final double[][] values = new double[QUANTITIES][ROOM];
    private int next;
    private int count;
    private double last = Double.NEGATIVE_INFINITY;

    /** Adds a state; one of the past begins anew, one that is hardly later is left out. */
    void add(double time, Movement motion) {
        if (time < last) {
            clear();
        }
        if (time < last + SECONDS / ROOM) {
            return;
        }
        Vec3 p = motion.position();
        double yaw = Math.toDegrees(Angles.rollPitchYaw(motion.orientation())[2]);
        double[] state = {p.x(), p.y(), p.z(), -p.z(), motion.velocity().norm(), yaw};
        times[next] = time;
        for (int q = 0; q < QUANTITIES; q++) {
            values[q][next] = state[q];
        }
        last = time;
        next = (next + 1) % ROOM;
        count = Math.min(count + 1, ROOM);
    }

    /** The time of the last state (s). */
    double last() {
        return last;
    }

    void clear() {
        count = 0;
        last = Double.NEGATIVE_INFINITY;
    }

    /** When the states were (s), those of the last minute, the oldest first. */
    double[] times() {
        return inOrder(times);
    }

    /** A quantity of the same states. */
    double[] values(int quantity) {
        return inOrder(values[quantity]);
    }

    private double[] inOrder(double[] of) {
        int skipped = 0;
        while (skipped < count && times[slot(skipped)] < last - SECONDS) {
            skipped++;
        }
        double[] ordered = new double[count - skipped];
        for (int i = 0; i < ordered.length; i++) {
            ordered[i] = of[slot(skipped + i)];
        }
        return ordered;
    }

    private int slot(int i) {
        return (next - count + i + ROOM) % ROOM;
    }
}
