package org.auvsim.diagnosis.verdict;

import org.auvsim.diagnosis.fit.Course;
import org.auvsim.diagnosis.fit.Judged;
import org.auvsim.diagnosis.fit.Starts;
import org.auvsim.diagnosis.fit.Uncertainty;
import org.auvsim.diagnosis.search.Search;

/**
 * Sets of equally many causes that the runs of the fit hardly tell from what was found. Held-out
 * runs never choose among them; but where they speak for another one, all runs have to be asked.
 * That is not done between laws of a drag, of which neither need be right.
 */
final class Rivals {
    /** Twice the logarithm of odds from which evidence is strong (Kass and Raftery 1995). */
    private static final double STRONG = 6;

    private final Search.Found found;
    private final Trial trial;
    private final Course course;

    Rivals(Search.Found found, Trial trial, Course course) {
        this.found = found;
        this.trial = trial;
        this.course = course;
    }

    /** Whether the held-out runs speak for one of them, what the runs of the fit say included. */
    boolean areAhead() {
        Judged best = found.best();
        if (!best.isWhite() || found.competitors().stream().noneMatch(this::isRival)) {
            return false;
        }
        double toBeat = best.score() + heldOut(best) - STRONG;
        return found.competitors().stream()
                        .filter(this::isRival)
                        .anyMatch(other -> other.score() + heldOut(other) < toBeat)
                && course.goesOn();
    }

    private boolean isRival(Judged other) {
        Judged best = found.best();
        return !other.isNone()
                && other.isWhite()
                && other.size() == best.size()
                && !DragLaw.isAllTheyDifferIn(best, other);
    }

    /**
     * The deviance of the held-out runs, numbers moved within what those of the fit leave open: of
     * errors that last, as many as tell something.
     */
    private double heldOut(Judged set) {
        Judged predicted = trial.prediction(set.fit().hypothesis(), course);
        Judged adjusted = Trial.adjusted(set, predicted, new Uncertainty(set).knowledge());
        double share = adjusted.outcome().independent() / adjusted.outcome().count();
        return share * (adjusted.outcome().deviance() + Starts.fineness(adjusted.fit()));
    }
}
