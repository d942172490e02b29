package org.auvsim.experiments.bench;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

import java.util.SplittableRandom;

class OverlapCheckTest {
    @Test
    void spheresThatTouchDoNotOverlap() {
        double[] centres = {0, 0, 0, 1, 0, 0, 1, 1.5, 0};
        assertThat(new OverlapCheck(3, 0.5).largest(centres)).isZero();
    }

    @ParameterizedTest
    @CsvSource({"0.5, 1", "0, 2", "0.999, 0.002"})
    void overlapIsInRadii(double distance, double overlap) {
        double[] centres = {-7.3, 2, 100, -7.3, 2 + distance, 100};
        assertThat(new OverlapCheck(2, 0.5).largest(centres)).isCloseTo(overlap, within(1e-12));
    }

    /** A planted pair among many that are apart, across cells and signs, at whatever places. */
    @ParameterizedTest(name = "seed {0}")
    @ValueSource(longs = {1, 2, 3, 4, 5})
    void findsAPlantedOverlap(long seed) {
        SplittableRandom random = new SplittableRandom(seed);
        int n = 1_000;
        double[] centres = new double[3 * n];
        for (int i = 0; i < n; i++) {
            int layer = i / 100;
            centres[3 * i] = 2.2 * (i % 10) - 11 + random.nextDouble(0.1);
            centres[3 * i + 1] = 2.2 * (i / 10 % 10) - 11 + random.nextDouble(0.1);
            centres[3 * i + 2] = 2.2 * layer - 11 + random.nextDouble(0.1);
        }
        OverlapCheck check = new OverlapCheck(n, 1);
        assertThat(check.largest(centres)).isZero();
        int guest = random.nextInt(n - 1);
        double depth = random.nextDouble(1e-9, 1);
        plant(centres, guest, guest + 1, 2 - depth, random);

        assertThat(check.largest(centres)).isGreaterThanOrEqualTo(depth - 1e-13);
    }

    /** Brings one to a distance from another one. */
    private static void plant(
            double[] centres, int guest, int host, double distance, SplittableRandom random) {
        double u = random.nextDouble(-1, 1);
        double angle = random.nextDouble(2 * Math.PI);
        double s = Math.sqrt(1 - u * u);
        centres[3 * guest] = centres[3 * host] + distance * s * Math.cos(angle);
        centres[3 * guest + 1] = centres[3 * host + 1] + distance * s * Math.sin(angle);
        centres[3 * guest + 2] = centres[3 * host + 2] + distance * u;
    }
}
