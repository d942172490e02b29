package org.auvsim.diagnosis.fit;

import org.apache.commons.math3.linear.RealMatrix;

import java.util.Optional;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;

/**
 * The likelihood's profile along each parameter: how much worse the fit becomes when one number is
 * held away from its best, all others fitted anew (Venzon &amp; Moolgavkar 1988). Where a model
 * bends, this is the width that the covariance at the optimum only guesses.
 */
final class Profile {
    /** So many standard deviations away the number is held. */
    private static final double AWAY = 2;

    private static final int STEPS = 4;

    /** Share of a standard deviation by which a number that is held may give way. */
    private static final double GIVE = 1e-4;

    /** The guess is at most so many times too small or too large. */
    private static final double MOST_STRETCH = 3;

    private final Judged fitted;
    private final Tangents tangents;
    private final RealMatrix covariance;
    private final double excess;

    /**
     * Of a fit that has converged.
     *
     * @param tangents there
     * @param covariance of its parameters, at the optimum
     * @param excess what a squared standard deviation comes to in cost
     */
    Profile(Judged fitted, Tangents tangents, RealMatrix covariance, double excess) {
        this.fitted = fitted;
        this.tangents = tangents;
        this.covariance = covariance;
        this.excess = excess;
    }

    /** By what factor each parameter's standard deviation is to be multiplied. */
    double[] stretches() {
        return IntStream.range(0, covariance.getRowDimension())
                .parallel()
                .mapToDouble(this::stretch)
                .toArray();
    }

    /** The mean of both sides, or the one that is within bounds. */
    private double stretch(int parameter) {
        return DoubleStream.of(-AWAY, AWAY)
                .mapToObj(away -> heldAway(parameter, away))
                .flatMap(Optional::stream)
                .mapToDouble(this::stretch)
                .average()
                .orElse(1);
    }

    private double stretch(Judged held) {
        double squared = Math.max(0, held.cost() - fitted.cost()) / excess;
        double stretch = AWAY / Math.sqrt(squared);
        return Math.max(1 / MOST_STRETCH, Math.min(MOST_STRETCH, stretch));
    }

    /** Empty if the number would be out of bounds there. */
    private Optional<Judged> heldAway(int parameter, double away) {
        double deviation = Math.sqrt(covariance.getEntry(parameter, parameter));
        if (!(deviation > 0)) {
            return Optional.empty();
        }
        double[] change = covariance.getColumn(parameter);
        for (int i = 0; i < change.length; i++) {
            change[i] *= away / deviation;
        }
        Hypothesis best = fitted.fit().hypothesis();
        double there = best.numbers()[parameter] + away * deviation;
        Hypothesis moved = best.plus(change);
        if (Math.abs(moved.numbers()[parameter] - there) > GIVE * deviation) {
            return Optional.empty();
        }
        Fit fit =
                fitted.fit()
                        .with(moved, fitted.fit().windows())
                        .knowing(Knowledge.of(moved.numbers(), parameter, GIVE * deviation));
        return Optional.of(Descent.of(fit).near(tangents).steps(STEPS));
    }
}
