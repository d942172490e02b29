package org.auvsim.diagnosis.verdict;

import org.auvsim.diagnosis.cause.Cause;
import org.auvsim.diagnosis.fit.Agreement;
import org.auvsim.diagnosis.fit.Fit;
import org.auvsim.diagnosis.fit.Hypothesis;
import org.auvsim.diagnosis.fit.Judged;
import org.auvsim.diagnosis.fit.Uncertainty;
import org.auvsim.diagnosis.result.Verdict;
import org.auvsim.diagnosis.search.Search;

import java.util.List;
import java.util.Set;

/**
 * What was found, and how held-out runs judge it.
 *
 * @param before the model as it was believed, on the held-out runs
 * @param after what was found on them
 * @param passes whether it holds there, or where all runs were searched with, for each by the
 *     others
 * @param agrees whether they want the same numbers
 */
record Judgement(
        Search.Found found,
        Trial trial,
        Judged before,
        Judged after,
        boolean passes,
        boolean agrees) {
    static Judgement of(Search.Found found, Trial trial) {
        Judged best = found.best();
        Judged before = trial.prediction(Hypothesis.NONE);
        Judged after = best.isNone() ? before : trial.prediction(best.fit().hypothesis());
        if (!best.isWhite()) {
            return new Judgement(found, trial, before, after, false, false);
        }
        Judged adjusted = Trial.adjusted(best, after, new Uncertainty(best).knowledge());
        boolean passes = Trial.passes(best, before, after, adjusted);
        boolean agrees = passes && Agreement.of(adjusted);
        return new Judgement(found, trial, before, after, passes, agrees);
    }

    /** The same of what all runs said, which was believed. */
    Judgement convinced(Search.Found all) {
        Hypothesis best = all.best().fit().hypothesis();
        return new Judgement(all, trial, before, trial.prediction(best), true, true);
    }

    /**
     * Where held-out runs do not bear out what was found: that nothing was, if the model as it was
     * believed leaves nothing but noise in all runs.
     */
    Judgement orAsBelieved() {
        Judged none = found.none();
        boolean isNone = !passes && none.isWhite() && Trial.passes(none, before, before, before);
        return isNone ? new Judgement(found.nothing(), trial, before, before, true, true) : this;
    }

    /** The same, where what was found is no cause that is known. */
    Judgement denied() {
        return new Judgement(found, trial, before, after, false, false);
    }

    /** Whether the fit is content and the held-out runs are not. */
    boolean isOfTwoMinds() {
        return found.best().isWhite() && !agrees;
    }

    /** What misses something: the runs of the fit, or else those that were held out. */
    Judged inDoubt() {
        return found.best().isWhite() ? after : found.best();
    }

    /** Whether what all runs say is something else than what those of the fit said. */
    boolean isNews(Search.Found all) {
        List<Cause> before = found.best().fit().hypothesis().causes();
        List<Cause> now = all.best().fit().hypothesis().causes();
        return !passes || !Set.copyOf(before).equals(Set.copyOf(now));
    }

    /** How well the held-out runs are foretold. */
    Foretold foretold() {
        return isUnexplained()
                ? Foretold.ofUnexplained(before, after, found.noise())
                : Foretold.of(before, after, found.noise());
    }

    /**
     * The model as it is believed on the runs of the fit: from the starts that suit what was found,
     * or, where that explains nothing, from those that suit it.
     */
    Fit believedOfFit() {
        return isUnexplained() ? found.none().fit() : found.best().fit().asBelieved();
    }

    /** The same on the held-out runs. */
    Fit believedOfHeldOut() {
        return isUnexplained() ? before.fit() : after.fit().asBelieved();
    }

    private boolean isUnexplained() {
        return verdict() == Verdict.UNEXPLAINED;
    }

    Verdict verdict() {
        if (!passes) {
            return Verdict.UNEXPLAINED;
        }
        return found.best().isNone() ? Verdict.NONE : Verdict.EXPLAINED;
    }
}
