package org.auvsim.viz.scene;

import java.util.Arrays;

/** How an object moved in the last minute of its time, in a ring that is bounded. */
final class Trail {
    /** How far it reaches back (s). */
    static final double SECONDS = 60;

    /** As many states as a trail keeps at most where there is room for it. */
    static final int MOST = 600;

    /** As many as a trail in a large world keeps. */
    static final int FEW = 60;

    private static final int FIRST = 4;
    private static final double ROUNDING = 1e-9;

    /** x, y, z (m), speed (m/s), yaw (rad). */
    private static final int SIZE = 5;

    private static final int SPEED = 3;
    private static final int YAW = 4;

    private final int most;
    private double[] states = new double[SIZE * FIRST];
    private double[] times = new double[FIRST];
    private int next;
    private int count;

    /** An empty one that keeps so many states at most. */
    Trail(int most) {
        this.most = most;
    }

    /** States this near to one another in time (s) are not kept both. */
    double apart() {
        return SECONDS / most;
    }

    void add(Movement motion) {
        if (count > 0 && motion.time() < time(count - 1) + apart() - ROUNDING) {
            return;
        }
        if (next == times.length && next < most) {
            int larger = Math.min(2 * next, most);
            times = Arrays.copyOf(times, larger);
            states = Arrays.copyOf(states, SIZE * larger);
        }
        next %= most;
        int to = SIZE * next;
        states[to] = motion.position().x();
        states[to + 1] = motion.position().y();
        states[to + 2] = motion.position().z();
        states[to + SPEED] = motion.velocity().norm();
        states[to + YAW] = Angles.rollPitchYaw(motion.orientation())[2];
        times[next] = motion.time();
        next++;
        count = Math.min(count + 1, most);
    }

    void clear() {
        next = 0;
        count = 0;
    }

    int count() {
        return count;
    }

    /** Coordinate {@code axis} of place {@code i}, 0 the oldest (m, world). */
    double place(int i, int axis) {
        return states[SIZE * slot(i) + axis];
    }

    /** The speed at place {@code i} (m/s). */
    double speed(int i) {
        return states[SIZE * slot(i) + SPEED];
    }

    /** The yaw at place {@code i} (rad). */
    double yaw(int i) {
        return states[SIZE * slot(i) + YAW];
    }

    /** When the object was at place {@code i} (s). */
    double time(int i) {
        return times[slot(i)];
    }

    private int slot(int i) {
        return (next - count + i + most) % most;
    }
}
