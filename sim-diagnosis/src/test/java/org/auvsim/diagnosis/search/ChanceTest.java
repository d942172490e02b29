package org.auvsim.diagnosis.search;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.apache.commons.math3.distribution.ChiSquaredDistribution;
import org.auvsim.diagnosis.fit.Gram;
import org.auvsim.diagnosis.fit.GramTest;
import org.junit.jupiter.api.Test;

import java.util.stream.IntStream;

/** Against what is known of the largest of independent, and of equal, numbers. */
class ChanceTest {
    private static final int COLUMNS = 60;
    private static final double RARE = 0.1;

    /** Columns of different sizes, all at right angles or all along one direction. */
    private static Gram columns(boolean areAlike) {
        double[][] products = new double[COLUMNS + 1][COLUMNS + 1];
        for (int a = 0; a < COLUMNS; a++) {
            for (int b = 0; b < COLUMNS; b++) {
                products[a][b] = areAlike || a == b ? (1.0 + a) * (1.0 + b) : 0;
            }
        }
        return new Gram(products);
    }

    private static double largestDrop(Gram gram) {
        return IntStream.range(0, gram.columns())
                .mapToObj(column -> new int[] {column})
                .mapToDouble(column -> gram.drop(column, gram.solve(column, GramTest.free(1))))
                .max()
                .orElseThrow();
    }

    @Test
    void theLargestOfManyIsLarger() {
        double ofOne = Math.pow(1 - RARE, 1.0 / COLUMNS);

        assertThat(Chance.of(columns(false), ChanceTest::largestDrop).exceededBy(RARE))
                .isCloseTo(
                        new ChiSquaredDistribution(1).inverseCumulativeProbability(ofOne),
                        within(1.2));
    }

    @Test
    void ofColumnsThatAreAlikeThereIsButOne() {
        assertThat(Chance.of(columns(true), ChanceTest::largestDrop).exceededBy(RARE))
                .isCloseTo(
                        new ChiSquaredDistribution(1).inverseCumulativeProbability(1 - RARE),
                        within(0.5));
    }

    /** What both differ in is below all rounding: there is nothing that noise could gain by it. */
    @Test
    void aSetOfColumnsThatAreAlikePromisesNoMoreThanOneOfThem() {
        double alike = 1 - 1e-15;
        Gram gram = new Gram(new double[][] {{1, alike, 0}, {alike, 1, 0}, {0, 0, 0}});
        int[] both = {0, 1};

        assertThat(
                        Chance.of(gram, g -> g.drop(both, g.solve(both, GramTest.free(2))))
                                .exceededBy(RARE))
                .isCloseTo(
                        new ChiSquaredDistribution(1).inverseCumulativeProbability(1 - RARE),
                        within(0.5));
    }
}
