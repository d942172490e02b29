package org.auvsim.viz.source;

import java.util.Arrays;

/**
 * Instants (s) that go up. Thinned out, it keeps every second of them, of those to come too, and
 * always the first and the newest.
 */
final class Times {
    private double[] times = new double[4];
    private int count;
    private int stride = 1;

    /** How many instants ago the last but one was. */
    private int distance;

    /** Where what belongs to an instant is to be written: a new place, or over the newest. */
    int add(double time) {
        if (count > 0 && time == times[count - 1]) {
            return count - 1;
        }
        if (count >= 2 && distance < stride) {
            distance++;
        } else {
            distance = 1;
            count++;
        }
        if (count > times.length) {
            times = Arrays.copyOf(times, grown(times.length));
        }
        times[count - 1] = time;
        return count - 1;
    }

    static int grown(int length) {
        return length + (length >> 1) + 1;
    }

    int count() {
        return count;
    }

    double get(int i) {
        return times[i];
    }

    double first() {
        return times[0];
    }

    double newest() {
        return count == 0 ? Double.NEGATIVE_INFINITY : times[count - 1];
    }

    /** The last one at a time (s) or before; -1 if all are after it. */
    int at(double time) {
        int found = Arrays.binarySearch(times, 0, count, time);
        return found >= 0 ? found : -found - 2;
    }

    /** Forgets those after a time (s). */
    void cut(double time) {
        count = at(time) + 1;
        distance = stride;
    }

    /** Drops every second one; {@link #kept} says which stay. */
    void thin() {
        int left = left(count);
        distance = count % 2 == 0 ? distance : stride + distance;
        for (int k = 0; k < left; k++) {
            times[k] = times[kept(k, count)];
        }
        count = left;
        stride *= 2;
        times = Arrays.copyOf(times, count + 1);
    }

    /** How many of so many stay. */
    static int left(int count) {
        return count == 0 ? 0 : count / 2 + 1;
    }

    /** Which of so many becomes the one with number {@code k}. */
    static int kept(int k, int count) {
        return Math.min(2 * k, count - 1);
    }
}
