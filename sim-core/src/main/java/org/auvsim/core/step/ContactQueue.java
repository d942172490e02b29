package org.auvsim.core.step;

import java.util.Arrays;

/**
 * Predicted events of a frame, region by region the earliest first: a binary heap in plain arrays.
 * Events of the same instant come in order of the ranks of the two, which is the order of their
 * ids.
 */
final class ContactQueue {
    /** In the place of the second body: the end of a body's segment, not a contact. */
    static final int NONE = -1;

    private int size;
    private int[] region = new int[64];
    private double[] time = new double[64];
    private int[] first = new int[64];
    private int[] second = new int[64];
    private int[] firstVersion = new int[64];
    private int[] secondVersion = new int[64];

    void clear() {
        size = 0;
    }

    boolean isEmpty() {
        return size == 0;
    }

    /** Offset (s) of the first event. */
    double time() {
        return time[0];
    }

    int first() {
        return first[0];
    }

    int second() {
        return second[0];
    }

    /** The version of the first one's trajectory for which the event was predicted. */
    int firstVersion() {
        return firstVersion[0];
    }

    int secondVersion() {
        return secondVersion[0];
    }

    /** Adds an event; those of smaller regions are taken first. */
    void add(int in, double t, int a, int b, int versionA, int versionB) {
        if (size == time.length) {
            grow();
        }
        int at = size++;
        while (at > 0) {
            int parent = (at - 1) >>> 1;
            if (!isBefore(in, t, a, b, parent)) {
                break;
            }
            move(parent, at);
            at = parent;
        }
        set(at, in, t, a, b, versionA, versionB);
    }

    void removeFirst() {
        int last = --size;
        int in = region[last];
        double t = time[last];
        int a = first[last];
        int b = second[last];
        int versionA = firstVersion[last];
        int versionB = secondVersion[last];
        int at = 0;
        while (2 * at + 1 < size) {
            int child = 2 * at + 1;
            if (child + 1 < size && isBefore(child + 1, child)) {
                child++;
            }
            if (isBefore(in, t, a, b, child)) {
                break;
            }
            move(child, at);
            at = child;
        }
        set(at, in, t, a, b, versionA, versionB);
    }

    private boolean isBefore(int one, int other) {
        return isBefore(region[one], time[one], first[one], second[one], other);
    }

    private boolean isBefore(int in, double t, int a, int b, int other) {
        if (in != region[other]) {
            return in < region[other];
        }
        if (t != time[other]) {
            return t < time[other];
        }
        return a != first[other] ? a < first[other] : b < second[other];
    }

    private void move(int from, int to) {
        set(
                to,
                region[from],
                time[from],
                first[from],
                second[from],
                firstVersion[from],
                secondVersion[from]);
    }

    private void set(int at, int in, double t, int a, int b, int versionA, int versionB) {
        region[at] = in;
        time[at] = t;
        first[at] = a;
        second[at] = b;
        firstVersion[at] = versionA;
        secondVersion[at] = versionB;
    }

    private void grow() {
        int capacity = 2 * size;
        region = Arrays.copyOf(region, capacity);
        time = Arrays.copyOf(time, capacity);
        first = Arrays.copyOf(first, capacity);
        second = Arrays.copyOf(second, capacity);
        firstVersion = Arrays.copyOf(firstVersion, capacity);
        secondVersion = Arrays.copyOf(secondVersion, capacity);
    }
}
