package org.auvsim.core.world;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;

/**
 * Tells a world's listeners of its events, in the order in which they happened: not before a step
 * is over, and none before all listeners know of the last.
 */
final class Announcements {
    private final List<WorldListener> listeners = new ArrayList<>();
    private final Deque<WorldEvent> waiting = new ArrayDeque<>();
    private boolean held;
    private boolean telling;

    void add(WorldListener listener) {
        listeners.add(listener);
    }

    void remove(WorldListener listener) {
        listeners.remove(listener);
    }

    /** Whether nobody listens, so that events need not be made. */
    boolean isUnheard() {
        return listeners.isEmpty();
    }

    /** Keeps events back from now on. */
    void hold() {
        held = true;
    }

    /** Tells what has been kept back. */
    void release() {
        held = false;
        tell();
    }

    void announce(WorldEvent event) {
        if (!isUnheard()) {
            waiting.add(event);
            tell();
        }
    }

    private void tell() {
        if (held || telling) {
            return;
        }
        telling = true;
        try {
            while (!waiting.isEmpty()) {
                WorldEvent event = waiting.remove();
                List.copyOf(listeners).forEach(listener -> listener.happened(event));
            }
        } finally {
            telling = false;
        }
    }
}
