package org.auvsim.diagnosis.fit;

import org.auvsim.diagnosis.cause.Cause;
import org.auvsim.diagnosis.residual.Outcome;
import org.auvsim.diagnosis.residual.Whiteness;

import java.util.List;

/**
 * A fit, its outcome and its score: Schwarz's criterion (1978), and a surcharge for each cause. The
 * smaller, the better.
 */
public record Judged(Fit fit, Outcome outcome, double score) {
    /** A fit by what it misses. */
    public static Judged of(Fit fit) {
        return of(fit, fit.outcome());
    }

    /** The same, what it misses known. */
    public static Judged of(Fit fit, Outcome outcome) {
        return new Judged(fit, outcome, outcome.deviance() + price(fit.hypothesis(), outcome));
    }

    private static double price(Hypothesis hypothesis, Outcome outcome) {
        return hypothesis.price(outcome.count(), outcome.independent());
    }

    /** The same at another price. */
    public Judged dearer(double by) {
        return new Judged(fit, outcome, score + by);
    }

    /** By how much the deviance must fall for its causes to be believed. */
    public double price() {
        return price(fit.hypothesis(), outcome);
    }

    /** The logarithm of the model's evidence (Schwarz 1978), up to a constant. */
    public double logEvidence() {
        double byNumbers = fit.hypothesis().size() * StrictMath.log(outcome.count());
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

    /** The largest deviate of the block sums over all runs. */
    public double whiteness() {
        double largest = 0;
        for (int r = 0; r < fit.data().size(); r++) {
            largest =
                    Math.max(
                            largest, Whiteness.largest(outcome.misses().get(r), fit.data().get(r)));
        }
        return largest;
    }

    /** Whether nothing is wrong with the model, by this. */
    public boolean isNone() {
        return fit.hypothesis().causes().isEmpty();
    }

    /** Squares of what is missed (standard deviations), and of what is known beside. */
    public double cost() {
        return outcome.cost();
    }
}
