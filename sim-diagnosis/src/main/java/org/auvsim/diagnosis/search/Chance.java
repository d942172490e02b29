package org.auvsim.diagnosis.search;

import org.apache.commons.math3.linear.Array2DRowRealMatrix;
import org.apache.commons.math3.linear.RealMatrix;
import org.apache.commons.math3.linear.RectangularCholeskyDecomposition;
import org.auvsim.diagnosis.fit.Gram;

import java.util.Arrays;
import java.util.Random;
import java.util.function.ToDoubleFunction;
import java.util.stream.IntStream;

/**
 * What noise alone makes the best of many causes promise: a parametric bootstrap (Efron &amp;
 * Tibshirani 1993, section 6.5) of the products of noise with all columns, whose covariance is that
 * of the columns themselves.
 */
final class Chance {
    private static final int DRAWS = 400;
    private static final long SEED = 1;

    /** A column that differs from others by less than this share of its size differs by nothing. */
    private static final double ALIKE = 1e-8;

    private final double[] scores;

    private Chance(double[] scores) {
        this.scores = scores;
    }

    /**
     * By drawing noise.
     *
     * @param gram of all columns
     * @param best what the best set promises where the misses are such
     */
    static Chance of(Gram gram, ToDoubleFunction<Gram> best) {
        Random random = new Random(SEED);
        RealMatrix factor = factor(gram);
        double[][] noises = new double[DRAWS][factor.getColumnDimension()];
        for (double[] noise : noises) {
            Arrays.setAll(noise, i -> random.nextGaussian());
        }
        double[] scores =
                IntStream.range(0, DRAWS)
                        .parallel()
                        .mapToDouble(
                                d -> best.applyAsDouble(gram.missing(factor.operate(noises[d]))))
                        .sorted()
                        .toArray();
        return new Chance(scores);
    }

    /**
     * A root of the products of the columns. What columns that are alike differ in by rounding
     * alone is left out: noise there would promise whatever rounding makes of it.
     */
    private static RealMatrix factor(Gram gram) {
        int n = gram.columns();
        RealMatrix alike = new Array2DRowRealMatrix(n, n);
        for (int a = 0; a < n; a++) {
            for (int b = 0; b < n; b++) {
                double sizes = gram.norm(a) * gram.norm(b);
                alike.setEntry(a, b, sizes > 0 ? gram.product(a, b) / sizes : 0);
            }
        }
        RealMatrix factor = new RectangularCholeskyDecomposition(alike, ALIKE).getRootMatrix();
        for (int a = 0; a < n; a++) {
            for (int b = 0; b < factor.getColumnDimension(); b++) {
                factor.multiplyEntry(a, b, gram.norm(a));
            }
        }
        return factor;
    }

    /** The score that noise exceeds with this probability: 0 where it hardly ever gains any. */
    double exceededBy(double probability) {
        int above = (int) Math.floor(probability * scores.length);
        return scores[scores.length - 1 - above];
    }
}
