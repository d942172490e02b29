package org.auvsim.core.step;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.PriorityQueue;
import java.util.SplittableRandom;

class ContactQueueTest {
    private static final Comparator<Event> ORDER =
            Comparator.comparingDouble(Event::time)
                    .thenComparingInt(Event::first)
                    .thenComparingInt(Event::second);

    private final ContactQueue queue = new ContactQueue();

    private record Event(double time, int first, int second, int versionA, int versionB) {}

    private void add(Event e) {
        queue.add(0, e.time, e.first, e.second, e.versionA, e.versionB);
    }

    private Event first() {
        return new Event(
                queue.time(),
                queue.first(),
                queue.second(),
                queue.firstVersion(),
                queue.secondVersion());
    }

    private List<Event> emptied() {
        List<Event> taken = new ArrayList<>();
        while (!queue.isEmpty()) {
            taken.add(first());
            queue.removeFirst();
        }
        return taken;
    }

    @Test
    void eventsOfOneInstantComeInOrderOfTheirBodies() {
        Event end = new Event(0.5, 3, ContactQueue.NONE, 7, 0);
        Event early = new Event(0.25, 9, 10, 1, 2);
        Event low = new Event(0.5, 1, 8, 3, 4);
        Event middle = new Event(0.5, 3, 4, 5, 6);
        Event high = new Event(0.5, 3, 5, 8, 9);
        List.of(high, low, end, early, middle).forEach(this::add);

        assertThat(emptied()).containsExactly(early, low, end, middle, high);
    }

    @Test
    void aClearedQueueIsEmptyAndCanBeUsedAgain() {
        add(new Event(1, 1, 2, 3, 4));
        queue.clear();

        assertThat(queue.isEmpty()).isTrue();
        Event next = new Event(2, 5, 6, 7, 8);
        add(next);
        assertThat(emptied()).containsExactly(next);
    }

    @ParameterizedTest(name = "seed {0}")
    @ValueSource(longs = {1, 2, 3, 4, 5, 6, 7, 8})
    void whateverComesAndGoesTheEarliestIsFirst(long seed) {
        SplittableRandom random = new SplittableRandom(seed);
        PriorityQueue<Event> expected = new PriorityQueue<>(ORDER);
        for (int k = 0; k < 2000; k++) {
            if (expected.isEmpty() || random.nextInt(5) > 1) {
                // No two of equal time and bodies, few times: many ties.
                Event event = new Event(random.nextInt(9) / 8.0, random.nextInt(9), k, k, -k);
                expected.add(event);
                add(event);
            } else {
                assertThat(first()).isEqualTo(expected.remove());
                queue.removeFirst();
            }
        }
        List<Event> rest = new ArrayList<>();
        while (!expected.isEmpty()) {
            rest.add(expected.remove());
        }
        assertThat(rest).hasSizeGreaterThan(64);
        assertThat(emptied()).isEqualTo(rest);
    }
}
