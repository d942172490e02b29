package org.auvsim.diagnosis.search;

import org.auvsim.diagnosis.cause.Cause;
import org.auvsim.diagnosis.cause.Guess;
import org.auvsim.diagnosis.cause.Parameter;
import org.auvsim.diagnosis.model.Variant;

import java.util.ArrayList;
import java.util.List;

/**
 * A guess of a cause among the columns of a screening.
 *
 * @param first the first of its columns
 */
public record Seed(Cause cause, Guess guess, int first) {
    /** All guesses of some causes, their columns from one on. */
    public static List<Seed> of(List<Cause> causes, List<Guesses> guesses, int firstColumn) {
        List<Seed> seeds = new ArrayList<>();
        int column = firstColumn;
        for (Guesses of : guesses) {
            if (!causes.contains(of.cause())) {
                continue;
            }
            for (Guess guess : of.guesses()) {
                seeds.add(new Seed(of.cause(), guess, column));
                column += guess.columns().size();
            }
        }
        return seeds;
    }

    /** A cause and where to begin. */
    public record Guesses(Cause cause, List<Guess> guesses) {
        /** What is begun at many places has fewer columns. */
        private static final int SWEPT = 100;

        /** Whether there are so many columns as of what swings, at any of many frequencies. */
        boolean isSwept() {
            return guesses.stream().mapToInt(guess -> guess.columns().size()).sum() > SWEPT;
        }
    }

    /** Which columns of the screening are its own. */
    public int[] columns() {
        int[] columns = new int[guess.columns().size()];
        for (int i = 0; i < columns.length; i++) {
            columns[i] = first + i;
        }
        return columns;
    }

    private double[] theta() {
        return guess.theta().stream().mapToDouble(Double::doubleValue).toArray();
    }

    /** The model with one column's number moved by its step. */
    public Variant moved(Variant model, int column) {
        double[] theta = theta();
        theta[guess.columns().get(column)] += guess.steps().get(column);
        return cause.in(model, theta);
    }

    /** The cause's numbers when its columns have these factors. */
    double[] solved(double[] factors) {
        double[] theta = theta();
        for (int i = 0; i < factors.length; i++) {
            int p = guess.columns().get(i);
            theta[p] = cause.parameters().get(p).clipped(theta[p] + guess.moved(i, factors[i]));
        }
        return theta;
    }

    /** The parameters that its columns are of. */
    List<Parameter> parameters() {
        return guess.columns().stream().map(cause.parameters()::get).toList();
    }

    /** The numbers that they begin at. */
    double[] numbers() {
        return guess.columns().stream().mapToDouble(guess.theta()::get).toArray();
    }
}
