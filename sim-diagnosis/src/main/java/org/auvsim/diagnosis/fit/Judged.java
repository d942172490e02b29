package org.auvsim.diagnosis.fit;

import org.auvsim.diagnosis.cause.Cause;
import org.auvsim.diagnosis.residual.Outcome;
import org.auvsim.diagnosis.residual.Whiteness;

import java.util.List;

/**
 * A fit, its outcome and its score: Schwarz's criterion (1978), and a surcharge for each cause. The
 * smaller, the better.
 *
 * @param told how many of its numbers count: all, unless some are known to leave no trace
 */
public record Judged(Fit fit, Outcome outcome, int told, double score) {
    /** A fit by what it misses. */
    public static Judged of(Fit fit) {
        return of(fit, fit.outcome());
    }

    /** The same, what it misses known. */
    public static Judged of(Fit fit, Outcome outcome) {
        int told = fit.hypothesis().free();
        return new Judged(
                fit, outcome, told, outcome.deviance() + price(fit.hypothesis(), outcome, told));
    }

    /** Numbers that leave no trace in the runs explain nothing, and cost nothing. */
    private static double price(Hypothesis hypothesis, Outcome outcome, int told) {
        double ofCauses = hypothesis.price();
        double ofNumbers = hypothesis.price(outcome.count(), outcome.independent()) - ofCauses;
        return told == 0 ? ofCauses : ofCauses + ofNumbers * told / hypothesis.free();
    }

    /** The same at another price. */
    public Judged dearer(double by) {
        return new Judged(fit, outcome, told, score + by);
    }

    /** The same where only so many of its numbers leave a trace. */
    public Judged telling(int numbers) {
        double less = price() - price(fit.hypothesis(), outcome, numbers);
        return new Judged(fit, outcome, numbers, score - less);
    }

    /** By how much the deviance must fall for its causes to be believed. */
    public double price() {
        return price(fit.hypothesis(), outcome, told);
    }

    /** The logarithm of the model's evidence (Schwarz 1978), up to a constant. */
    public double logEvidence() {
        double byNumbers = told * StrictMath.log(outcome.count());
        return -(score - price() + byNumbers) / 2;
    }

    /**
     * Whether another one, which has only some of its causes, fits better: then its own fit was
     * given up before it was at its best, and tells nothing.
     */
    public boolean isBehind(Judged other) {
        List<Cause> causes = fit.hypothesis().causes();
        List<Cause> fewer = other.fit.hypothesis().causes();
        return fewer.size() < causes.size()
                && causes.containsAll(fewer)
                && other.outcome.deviance() < outcome.deviance();
    }

    /** Whether both are of the same causes. */
    public boolean hasCausesOf(Judged other) {
        return fit.hypothesis().hasCausesOf(other.fit.hypothesis());
    }

    /** Whether what is missed of each run is noise. */
    public boolean isWhite() {
        return whiteness() < Whiteness.LIMIT;
    }

    /** The largest deviate of the block sums over all runs, and of all of them together. */
    public double whiteness() {
        return Whiteness.largest(outcome.misses(), fit.data());
    }

    /** How many causes it has. */
    public int size() {
        return fit.hypothesis().causes().size();
    }

    /** Whether nothing is wrong with the model, by this. */
    public boolean isNone() {
        return size() == 0;
    }

    /** By how much its cost is above that of noise alone; below 0 where chance has it so. */
    public double beyondNoise() {
        return cost() - outcome.count();
    }

    /** Squares of what is missed (standard deviations), and of what is known beside. */
    public double cost() {
        return outcome.cost();
    }
}
