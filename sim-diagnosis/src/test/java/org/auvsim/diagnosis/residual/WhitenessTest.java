package org.auvsim.diagnosis.residual;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.apache.commons.math3.distribution.ChiSquaredDistribution;
import org.apache.commons.math3.distribution.NormalDistribution;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.run.MeasuredRunBuilder;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;

/** The deviate of a chi square against both distributions: it is as rare as it says. */
class WhitenessTest {
    private static double largest(double[] misses, Misses of) {
        return Whiteness.largest(List.of(misses), List.of(of));
    }

    /** Of a fix of the position in every tenth row. */
    @Test
    void noiseInSomeRowsIsNoise() {
        Random random = new Random(4);
        MeasuredRunBuilder builder = MeasuredRun.named("run");
        double[] fixes = new double[4000];
        for (int k = 0; k < fixes.length; k++) {
            fixes[k] = k % 10 == 0 ? random.nextGaussian() : 0;
            builder.at(0.1 * k)
                    .position(k % 10 == 0 ? fixes[k] : Double.NaN, Double.NaN, Double.NaN);
        }
        MeasuredRun run = builder.build();

        double largest = largest(fixes, new Misses(run, Noise.of(List.of(run))));

        assertThat(largest).isLessThan(2);
    }

    /** Of a fix each second, 46 of them: means over blocks are next to nothing. */
    @Test
    void whatSwingsFasterThanABlockIsNoNoise() {
        assertThat(swing(1)).isGreaterThan(Whiteness.LIMIT);
    }

    /** Errors of a sensor may last as long. */
    @Test
    void nothingIsSaidOfSwingsAsSmallAsNoise() {
        assertThat(swing(0.4)).isLessThan(2);
    }

    /** The deviate of so many times a swing of 0.8 m beside noise of 0.1 m. */
    private static double swing(double times) {
        Random random = new Random(4);
        MeasuredRunBuilder builder = MeasuredRun.named("run");
        double[] misses = new double[46];
        for (int k = 0; k < misses.length; k++) {
            misses[k] = 0.8 * Math.sin(2 * Math.PI * (k - 1.5) / 8) + 0.1 * random.nextGaussian();
            builder.at(k).position(misses[k], Double.NaN, Double.NaN);
        }
        MeasuredRun run = builder.build();
        Misses of = new Misses(run, Noise.of(List.of(run)));
        for (int k = 0; k < misses.length; k++) {
            misses[k] *= times / of.deviation(k);
        }
        return largest(misses, of);
    }

    /** A swing of a third of the noise in each of nine channels. */
    @Test
    void whatEachChannelHidesInNoiseAllOfThemTell() {
        List<double[]> misses = new ArrayList<>();
        List<Misses> of = new ArrayList<>();
        double largestAlone = 0;
        for (int r = 0; r < 9; r++) {
            misses.add(hidden(r, 0.33));
            of.add(ofNoise());
            largestAlone = Math.max(largestAlone, largest(misses.get(r), of.get(r)));
        }
        assertThat(largestAlone).isLessThan(Whiteness.LIMIT);
        assertThat(Whiteness.largest(misses, of)).isGreaterThan(Whiteness.LIMIT);
    }

    /** A tenth of an error stays from row to row, as that of a filtered sensor. */
    @Test
    void ofErrorsThatHardlyLastManyChannelsSayNothing() {
        List<double[]> misses = new ArrayList<>();
        List<Misses> of = new ArrayList<>();
        for (int r = 0; r < 30; r++) {
            double[] errors = hidden(r, 0);
            for (int k = 1; k < errors.length; k++) {
                errors[k] += 0.1 * errors[k - 1];
            }
            misses.add(errors);
            of.add(ofNoise());
        }
        assertThat(Whiteness.largest(misses, of)).isLessThan(Whiteness.LIMIT);
    }

    private static Misses ofNoise() {
        Random random = new Random(4);
        MeasuredRunBuilder builder = MeasuredRun.named("run");
        for (int k = 0; k < 400; k++) {
            builder.at(0.1 * k).position(random.nextGaussian(), Double.NaN, Double.NaN);
        }
        MeasuredRun run = builder.build();
        return new Misses(run, Noise.of(List.of(run)));
    }

    private static double[] hidden(int seed, double swing) {
        Random random = new Random(seed);
        double[] misses = new double[400];
        Arrays.setAll(misses, k -> swing * Math.sin(0.05 * k + seed) + random.nextGaussian());
        return misses;
    }

    @ParameterizedTest(name = "1 in 10 to the {1} of {0}")
    @CsvSource({"2, 2", "2, 5", "8, 3", "8, 5", "30, 5", "300, 5"})
    void aDeviateIsAsRareAsItsChiSquare(int freedom, int digits) {
        double rare = Math.pow(10, -digits);
        double chiSquare =
                new ChiSquaredDistribution(freedom).inverseCumulativeProbability(1 - rare);
        double deviate = new NormalDistribution().inverseCumulativeProbability(1 - rare);

        assertThat(Whiteness.deviate(chiSquare, freedom)).isCloseTo(deviate, within(0.2));
    }
}
