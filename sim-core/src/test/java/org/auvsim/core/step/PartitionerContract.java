package org.auvsim.core.step;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.core.math.Vec3;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.stream.LongStream;

/** What every {@link CollisionPartitioner} keeps; extend it to test one of your own. */
public abstract class PartitionerContract {
    private static final double DT = 0.1;

    /** The partitioner. */
    protected abstract CollisionPartitioner partitioner();

    static LongStream seeds() {
        return LongStream.rangeClosed(1, 20);
    }

    /** Equation 5.1 of the thesis, with the swept spheres worked out here once more. */
    @ParameterizedTest(name = "seed {0}")
    @MethodSource("seeds")
    void eachPairWhoseSweptSpheresOverlapSharesASet(long seed) {
        Motion motion = Scene.crowd(seed);

        CollisionSets sets = Scene.partition(motion, partitioner(), DT);

        Set<Long> together = pairsOf(sets);
        List<String> missing = new ArrayList<>();
        for (int i = 0; i < motion.size(); i++) {
            for (int j = i + 1; j < motion.size(); j++) {
                if (sweptSpheresOverlap(motion, i, j) && !together.contains(pair(i, j))) {
                    missing.add(i + " and " + j);
                }
            }
        }
        assertThat(missing).isEmpty();
    }

    @ParameterizedTest(name = "seed {0}")
    @MethodSource("seeds")
    void noPairIsExaminedTwice(long seed) {
        CollisionSets sets = Scene.partition(Scene.crowd(seed), partitioner(), DT);

        long before = -1;
        for (int k = 0; k < sets.pairCount(); k++) {
            assertThat(sets.first(k)).isLessThan(sets.second(k));
            assertThat(pair(sets.first(k), sets.second(k))).isGreaterThan(before);
            before = pair(sets.first(k), sets.second(k));
        }
    }

    @Test
    void anEmptyWorldHasNoPairs() {
        assertThat(Scene.partition(Scene.of(), partitioner(), DT).pairCount()).isZero();
    }

    private static boolean sweptSpheresOverlap(Motion motion, int i, int j) {
        Vec3 between = middle(motion, i).minus(middle(motion, j));
        double reach = reach(motion, i) + reach(motion, j);
        return between.norm() < reach - 1e-9;
    }

    private static Vec3 middle(Motion motion, int i) {
        return motion.position(i, 0).plus(motion.position(i, DT)).times(0.5);
    }

    private static double reach(Motion motion, int i) {
        return motion.radius(i, 0) + motion.displacement(i, DT) / 2;
    }

    private static Set<Long> pairsOf(CollisionSets sets) {
        Set<Long> pairs = new HashSet<>();
        for (int s = 0; s < sets.count(); s++) {
            int[] members = Arrays.stream(sets.set(s)).sorted().toArray();
            for (int a = 0; a < members.length; a++) {
                for (int b = a + 1; b < members.length; b++) {
                    pairs.add(pair(members[a], members[b]));
                }
            }
        }
        return pairs;
    }

    private static long pair(int i, int j) {
        return (long) i << 32 | j;
    }
}
