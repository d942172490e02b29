package org.auvsim.diagnosis.fit;

import org.auvsim.diagnosis.residual.Whiteness;

import java.util.List;

/**
 * Whether runs want the same parameters. Twice the logarithm of the ratio of likelihoods,
 * parameters free by held, is a chi square of as many degrees of freedom as there are parameters
 * that were freed (Wilks 1938).
 */
public final class Agreement {
    private static final int STEPS = 12;

    /** Above this they do not. */
    private static final double LIMIT = 5;

    private Agreement() {}

    /**
     * Whether runs that had no part in a fit want what it says, within what that leaves open, to
     * which they were held. A cause that stands for another one can often be moved to fit other
     * runs, but not so. Nor can one that is right in a model which is only nearly so: that they
     * disagree is a reason to ask all runs together.
     */
    public static boolean of(Judged held) {
        int parameters = held.fit().hypothesis().size();
        if (parameters == 0) {
            return true;
        }
        Fit fit = held.fit().knowing(Knowledge.NONE);
        Judged free = Descent.of(fit).steps(STEPS);
        return isByChance(held, free.cost(), parameters);
    }

    /**
     * Whether runs that were fitted together want the same parameters, each alone. What imitates
     * something else is often another thing in each run.
     *
     * @param turns of what was fitted
     */
    public static boolean ofEach(Judged fitted, LeaveOneOut turns) {
        List<Judged> alone = turns.alone();
        int parameters = fitted.fit().hypothesis().size() * (alone.size() - 1);
        double free = alone.stream().mapToDouble(Judged::cost).sum();
        return parameters == 0 || isByChance(fitted, free, parameters);
    }

    /** Whether so many numbers more, fitted to noise, would cost as little. */
    private static boolean isByChance(Judged held, double free, int parameters) {
        double excess = Math.max(1, held.cost() / held.outcome().count());
        double ratio = (held.cost() - free) / excess;
        return Whiteness.deviate(Math.max(0, ratio), parameters) < LIMIT;
    }
}
