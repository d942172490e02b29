package org.auvsim.diagnosis.fit;

import org.apache.commons.math3.linear.Array2DRowRealMatrix;
import org.apache.commons.math3.linear.CholeskyDecomposition;
import org.apache.commons.math3.linear.RealMatrix;

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

    /** Share of a column's size that is added to it, so that columns may be alike. */
    private static final double RIDGE = 1e-8;

    private static final double SYMMETRIC = 1e-12;
    private static final double POSITIVE = 1e-12;

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
        double[][] noises = new double[DRAWS][gram.columns()];
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

    /** A root of the products of the columns. */
    private static RealMatrix factor(Gram gram) {
        int n = gram.columns();
        RealMatrix alike = new Array2DRowRealMatrix(n, n);
        for (int a = 0; a < n; a++) {
            for (int b = 0; b < n; b++) {
                double sizes = gram.norm(a) * gram.norm(b);
                alike.setEntry(a, b, sizes > 0 ? gram.product(a, b) / sizes : 0);
            }
            alike.setEntry(a, a, 1 + RIDGE);
        }
        RealMatrix factor = new CholeskyDecomposition(alike, SYMMETRIC, POSITIVE).getL();
        for (int a = 0; a < n; a++) {
            for (int b = 0; b <= a; b++) {
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
