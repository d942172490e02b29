package org.auvsim.viz.scene;

/** The last places of an object, in a ring that never grows. */
final class Trail {
    /** Places this near to one another in time (s) are not kept both. */
    static final double APART = 0.1;

    /** So many places are kept: those of a minute. */
    static final int MOST = 600;

    private static final double ROUNDING = 1e-9;

    private final double[] places = new double[3 * MOST];
    private final double[] times = new double[MOST];
    private int next;
    private int count;

    void add(double time, double x, double y, double z) {
        if (count > 0 && time < time(count - 1) + APART - ROUNDING) {
            return;
        }
        places[3 * next] = x;
        places[3 * next + 1] = y;
        places[3 * next + 2] = z;
        times[next] = time;
        next = (next + 1) % MOST;
        count = Math.min(count + 1, MOST);
    }

    void clear() {
        count = 0;
    }

    int count() {
        return count;
    }

    /** Coordinate {@code axis} of place {@code i}, 0 the oldest (m, world). */
    double place(int i, int axis) {
        return places[3 * slot(i) + axis];
    }

    /** When the object was at place {@code i} (s). */
    double time(int i) {
        return times[slot(i)];
    }

    private int slot(int i) {
        return (next - count + i + MOST) % MOST;
    }
}
