package org.auvsim.core.step;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.core.math.Vec3;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

import java.util.List;
import java.util.stream.LongStream;

/** What every {@link CollisionFinder} keeps; extend it to test one of your own. */
public abstract class FinderContract {
    private static final double DT = 0.05;

    /** The finder. */
    protected abstract CollisionFinder finder();

    static LongStream seeds() {
        return LongStream.rangeClosed(1, 40);
    }

    @ParameterizedTest(name = "seed {0}")
    @MethodSource("seeds")
    void aPairTouchesAndApproachesAtTheInstantFound(long seed) {
        Motion motion = Scene.crowd(seed);
        CollisionSets sets = Scene.partition(motion, new AllPairsPartitioner(), DT);

        double earliest = finder().earliest(motion, sets, DT);

        if (earliest < Double.POSITIVE_INFINITY) {
            assertThat(earliest).isBetween(0.0, DT);
            assertThat(touching(motion, sets, earliest)).isTrue();
        }
    }

    private static boolean touching(Motion motion, CollisionSets sets, double offset) {
        for (int k = 0; k < sets.pairCount(); k++) {
            int i = sets.first(k);
            int j = sets.second(k);
            if (motion.overlap(i, j, offset) && motion.approaching(i, j, offset)) {
                return true;
            }
        }
        return false;
    }

    @ParameterizedTest(name = "seed {0}")
    @MethodSource("seeds")
    void searchingMovesNothingAndIsRepeatable(long seed) {
        Motion motion = Scene.crowd(seed);
        CollisionSets sets = Scene.partition(motion, new AllPairsPartitioner(), DT);
        List<Vec3> before = Scene.positions(motion);

        double first = finder().earliest(motion, sets, DT);

        assertThat(finder().earliest(motion, sets, DT)).isEqualTo(first);
        assertThat(Scene.positions(motion)).isEqualTo(before);
    }

    @Test
    void whatMeetsSquarelyAndStaysIsFound() {
        Motion motion =
                Scene.of(
                        Scene.ball("A", 0.5).position(-0.55, 0, 0).velocity(4, 0, 0).build(),
                        Scene.ball("B", 0.5).position(0.55, 0, 0).velocity(-4, 0, 0).build());
        CollisionSets sets = Scene.partition(motion, new AllPairsPartitioner(), DT);

        assertThat(finder().earliest(motion, sets, DT)).isBetween(0.0125 - 1e-12, DT);
    }

    @Test
    void whatIsFarApartDoesNotCollide() {
        Motion motion =
                Scene.of(
                        Scene.ball("A", 0.5).velocity(-1, 0, 0).build(),
                        Scene.ball("B", 0.5).position(9, 0, 0).velocity(1, 0, 0).build());
        CollisionSets sets = Scene.partition(motion, new AllPairsPartitioner(), DT);

        assertThat(finder().earliest(motion, sets, DT)).isInfinite();
    }
}
