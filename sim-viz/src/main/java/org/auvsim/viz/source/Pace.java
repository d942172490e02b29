package org.auvsim.viz.source;

import org.auvsim.auvsml.message.control.SimulatorStateResponse;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.OptionalDouble;

/** How fast a simulator's time passes, by what it has told in the last seconds. */
final class Pace {
    /** What was told longer ago (ns) does not count. */
    private static final long LONGEST = 5_000_000_000L;

    /** In less than this (ns) nothing can be said. */
    private static final long SHORTEST = 900_000_000L;

    private final Deque<Told> told = new ArrayDeque<>();

    private record Told(double time, String rate, long nanos) {}

    /** The simulator has told how it stands, now (ns of the machine's clock). */
    synchronized void hear(SimulatorStateResponse state, long nanos) {
        Told last = told.peekLast();
        if (last != null && (last.time() > state.time() || !last.rate().equals(state.rate()))) {
            told.clear();
        }
        if (!state.running()) {
            told.clear();
            return;
        }
        told.addLast(new Told(state.time(), state.rate(), nanos));
        while (nanos - told.getFirst().nanos() > LONGEST) {
            told.removeFirst();
        }
    }

    /** Nothing is known any more. */
    synchronized void forget() {
        told.clear();
    }

    /** World seconds a second; empty while too little is known. */
    synchronized OptionalDouble reached() {
        Told first = told.peekFirst();
        Told last = told.peekLast();
        if (first == null || last == null || last.nanos() - first.nanos() < SHORTEST) {
            return OptionalDouble.empty();
        }
        return OptionalDouble.of(
                (last.time() - first.time()) / ((last.nanos() - first.nanos()) * 1e-9));
    }
}
