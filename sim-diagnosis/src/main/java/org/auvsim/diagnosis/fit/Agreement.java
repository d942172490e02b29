package org.auvsim.diagnosis.fit;

import org.auvsim.diagnosis.residual.Whiteness;

/**
 * Whether runs that had no part in a fit want the same parameters as those that had. Twice the
 * logarithm of the ratio of likelihoods, parameters free by held to what the fit says of them, is a
 * chi square of as many degrees of freedom as there are parameters (Wilks 1938). A cause that
 * stands for another one can often be moved to fit other runs, but not within what it said. Nor can
 * one that is right in a model which is only nearly so: that they disagree is a reason to ask all
 * runs together, not to doubt what they agree on.
 */
public final class Agreement {
    private static final int STEPS = 12;

    /** Above this they do not. */
    private static final double LIMIT = 5;

    private Agreement() {}

    /** Whether a hypothesis whose parameters were moved within what is known of them agrees. */
    public static boolean of(Judged held) {
        int parameters = held.fit().hypothesis().size();
        if (parameters == 0) {
            return true;
        }
        Fit fit = held.fit().knowing(Knowledge.NONE);
        Judged free = Descent.of(fit).steps(STEPS);
        double excess = Math.max(1, held.cost() / held.outcome().count());
        double ratio = (held.cost() - free.cost()) / excess;
        return Whiteness.deviate(Math.max(0, ratio), parameters) < LIMIT;
    }
}
