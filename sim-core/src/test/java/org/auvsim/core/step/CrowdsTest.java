package org.auvsim.core.step;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

import java.util.Arrays;
import java.util.stream.IntStream;

class CrowdsTest {
    private static final int[] HEAP = IntStream.range(10, 110).toArray();

    private final Crowds crowds = new Crowds(120);

    private int[] crowded() {
        return IntStream.range(0, 120).filter(crowds::isCrowded).toArray();
    }

    private void settle(int[] members, int times) {
        for (int k = 0; k < times; k++) {
            crowds.settled(members, members.length);
        }
    }

    @Test
    void aHeapOfAHundredIsFollowedThroughTenCollisionsAFrame() {
        settle(HEAP, 10);

        assertThat(crowds.any()).isFalse();
        assertThat(crowded()).isEmpty();
    }

    @Test
    void oneCollisionMoreCrowdsItsMembersAndNobodyElse() {
        settle(HEAP, 11);

        assertThat(crowds.any()).isTrue();
        assertThat(crowded()).containsExactly(HEAP);
    }

    @Test
    void theCollisionsOfDifferentIslandsAddUpForTheBodyInThem() {
        int[] left = IntStream.rangeClosed(0, 50).toArray();
        int[] right = IntStream.rangeClosed(50, 100).toArray();
        settle(left, 10);
        settle(right, 10);

        assertThat(crowded()).containsExactly(50);
    }

    @Test
    void onlyTheFirstOfTheMembersCount() {
        for (int k = 0; k < 21; k++) {
            crowds.settled(HEAP, 50);
        }

        assertThat(crowded()).containsExactly(Arrays.copyOf(HEAP, 50));
    }

    @Test
    void aNewFrameBeginsWithoutCrowds() {
        settle(HEAP, 11);

        crowds.clear();

        assertThat(crowds.any()).isFalse();
        settle(HEAP, 10);
        assertThat(crowded()).isEmpty();
    }
}
