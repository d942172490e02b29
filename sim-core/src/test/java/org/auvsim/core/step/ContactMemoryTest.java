package org.auvsim.core.step;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.core.volume.Manifold;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.util.HashMap;
import java.util.Map;
import java.util.SplittableRandom;

class ContactMemoryTest {
    private static final double NEVER = Double.NEGATIVE_INFINITY;

    private final ContactMemory memory = new ContactMemory();

    /** A pair hits, and has points along x whose forces tell of which pair and point they are. */
    private void remember(int a, int b, double time, int points) {
        int entry = memory.entry(a, b, time);
        memory.hit(entry, time, a);
        memory.clearPoints(entry);
        for (int k = 0; k < points; k++) {
            memory.addPoint(entry, k, 0, 0, force(a, b, k), -a, -b, -k);
        }
    }

    private static double force(int a, int b, int k) {
        return 100_000 * a + 100 * b + k;
    }

    private void assertRemembered(int a, int b, double time, double hit, int points) {
        int entry = memory.entry(a, b, time);
        assertThat(memory.lastHit(entry)).isEqualTo(hit);
        assertThat(memory.repeats(entry)).isEqualTo(a);
        for (int k = 0; k < points; k++) {
            int at = memory.nearest(entry, k, 0, 0, 0.1);
            assertThat(memory.force(at)).isEqualTo(force(a, b, k));
            assertThat(memory.force(at + 1)).isEqualTo(-a);
            assertThat(memory.force(at + 2)).isEqualTo(-b);
            assertThat(memory.force(at + 3)).isEqualTo(-k);
        }
        assertThat(memory.nearest(entry, points, 0, 0, 0.1)).isEqualTo(-1);
    }

    private void assertNew(int a, int b, double time) {
        int entry = memory.entry(a, b, time);
        assertThat(memory.lastHit(entry)).isEqualTo(NEVER);
        assertThat(memory.repeats(entry)).isZero();
        assertThat(memory.nearest(entry, 0, 0, 0, Double.MAX_VALUE)).isEqualTo(-1);
    }

    @Test
    void aPairThatNeverMetHasNothing() {
        remember(1, 2, 0, 3);

        assertNew(2, 1, 0);
        assertRemembered(1, 2, 0, 0, 3);
    }

    @Test
    void theNearestPointWithinADistanceIsFound() {
        int entry = memory.entry(1, 2, 0);
        memory.addPoint(entry, 1, 1, 1, 10, 0, 0, 0);
        memory.addPoint(entry, 1, 1, 1.5, 20, 0, 0, 0);
        memory.addPoint(entry, 1, 4, 1, 30, 0, 0, 0);

        assertThat(memory.force(memory.nearest(entry, 1, 1, 1.2, 1))).isEqualTo(10);
        assertThat(memory.force(memory.nearest(entry, 1, 1, 1.3, 1))).isEqualTo(20);
        assertThat(memory.force(memory.nearest(entry, 1, 3, 1, 1))).isEqualTo(30);
        assertThat(memory.nearest(entry, 1, 3, 1, 0.9)).isEqualTo(-1);
        assertThat(memory.nearest(entry, 2.5, 1, 1, 1)).isEqualTo(-1);
    }

    @Test
    void newPointsTakeThePlaceOfOldOnes() {
        remember(1, 2, 0, Manifold.MAXIMUM);
        remember(1, 2, 0.1, 2);

        assertRemembered(1, 2, 0.1, 0.1, 2);
    }

    @Test
    void allThatIsInUseSurvivesWhenRoomIsMade() {
        for (int a = 0; a < 500; a++) {
            remember(a, a + 7, 0.001 * a, a % (Manifold.MAXIMUM + 1));
        }

        for (int a = 0; a < 500; a++) {
            assertRemembered(a, a + 7, 0.5, 0.001 * a, a % (Manifold.MAXIMUM + 1));
        }
    }

    /** Room is made for the 17th pair. */
    @Test
    void whatHasNotMetForLongIsForgottenWhenRoomIsMade() {
        for (int a = 0; a < 16; a++) {
            remember(a, 99, 0, 4);
        }
        for (int a = 1; a < 16; a += 2) {
            memory.entry(a, 99, 1.5);
        }

        remember(50, 51, 2.5, 1);

        for (int a = 1; a < 16; a += 2) {
            assertRemembered(a, 99, 2.5, 0, 4);
        }
        assertRemembered(50, 51, 2.5, 2.5, 1);
        for (int a = 0; a < 16; a += 2) {
            assertNew(a, 99, 2.5);
        }
    }

    @Test
    void aCopyGoesItsOwnWay() {
        remember(1, 2, 0, 2);
        ContactMemory copy = memory.copy();

        int there = copy.entry(1, 2, 1);
        copy.hit(there, 1, 9);
        copy.clearPoints(there);
        copy.addPoint(there, 0, 0, 0, -1, -1, -1, -1);

        assertRemembered(1, 2, 1, 0, 2);
        assertThat(copy.lastHit(copy.entry(1, 2, 1))).isEqualTo(1);
    }

    @Test
    void nothingIsLeftWhenAllIsForgotten() {
        for (int a = 0; a < 20; a++) {
            remember(a, a + 1, 0, 2);
        }

        memory.clear();

        for (int a = 0; a < 20; a++) {
            assertNew(a, a + 1, 0);
        }
    }

    /** Pairs come and go over some seconds; whoever met within the last one is remembered. */
    @ParameterizedTest(name = "seed {0}")
    @ValueSource(longs = {1, 2, 3, 4, 5, 6, 7, 8})
    void whoHasMetLatelyIsRemembered(long seed) {
        SplittableRandom random = new SplittableRandom(seed);
        Map<Integer, Double> hits = new HashMap<>();
        int remembered = 0;
        for (int k = 0; k < 3000; k++) {
            double time = 0.002 * k;
            int a = k / 30 + random.nextInt(60);
            int b = a + 1;
            Double hit = hits.put(a, time);
            if (hit != null && hit >= time - 1) {
                assertRemembered(a, b, time, hit, 3);
                remembered++;
            }
            remember(a, b, time, 3);
        }
        assertThat(remembered).isGreaterThan(1000);
    }
}
