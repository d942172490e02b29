package org.auvsim.viz.source;

import java.util.ArrayList;
import java.util.List;

/** Things in order of the times at which they happened. */
final class Timeline<T> {
    private final List<Dated<T>> all = new ArrayList<>();

    /**
     * @param time (s)
     * @param order the number of the entry that told it
     */
    private record Dated<T>(double time, int order, T item) {}

    /** Adds what entry {@code order} told, after all others of this time (s). */
    void add(double time, int order, T item) {
        all.add(countUntil(time), new Dated<>(time, order, item));
    }

    /** How many happened at a time (s) or before. */
    int countUntil(double time) {
        int from = 0;
        int to = all.size();
        while (from < to) {
            int middle = (from + to) >>> 1;
            if (all.get(middle).time() <= time) {
                from = middle + 1;
            } else {
                to = middle;
            }
        }
        return from;
    }

    int count() {
        return all.size();
    }

    T get(int i) {
        return all.get(i).item();
    }

    double time(int i) {
        return all.get(i).time();
    }

    /** The last one; {@code none} if there is none. */
    T last(T none) {
        return all.isEmpty() ? none : all.getLast().item();
    }

    void cut(Cut cut) {
        all.removeIf(one -> cut.drops(one.time(), one.order()));
    }
}
