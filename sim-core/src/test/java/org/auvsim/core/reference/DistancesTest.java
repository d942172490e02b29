package org.auvsim.core.reference;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.core.volume.PairQueries;
import org.auvsim.core.volume.Pose;
import org.auvsim.core.volume.Separation;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;

/**
 * The distances that the engine works with, held against the reference, for each pair of volumes.
 */
class DistancesTest {
    private static final int SEEDS = 300;

    static Stream<Arguments> pairs() {
        return Kind.pairs();
    }

    @ParameterizedTest(name = "{0} and {1}, seeds 1 to " + SEEDS)
    @MethodSource("pairs")
    void theGapIsThatOfTheReference(Kind a, Kind b) {
        PairQueries queries = PairQueries.standard();
        Separation separation = new Separation();
        List<String> wrong = new ArrayList<>();
        int compared = 0;
        for (long seed = 1; seed <= SEEDS; seed++) {
            DrawnPair pair = DrawnPair.of(a, b, seed);
            for (double t : new double[] {0.1, 0.3, 0.5}) {
                double gap = pair.gap(t);
                if (gap < 0.9 * Union.WIDE) {
                    Pose poseA = pair.pose(0, t);
                    Pose poseB = pair.pose(1, t);
                    double distance =
                            queries.distance(
                                    pair.volume(0), poseA, pair.volume(1), poseB, separation);
                    compared++;
                    boolean agree = gap > 0 ? Math.abs(distance - gap) < 1e-9 : distance <= 1e-9;
                    if (!agree) {
                        wrong.add("seed %d, %s s: %s, not %s".formatted(seed, t, distance, gap));
                    }
                }
            }
        }
        assertThat(wrong).isEmpty();
        assertThat(compared).isGreaterThan(SEEDS / 2);
    }
}
