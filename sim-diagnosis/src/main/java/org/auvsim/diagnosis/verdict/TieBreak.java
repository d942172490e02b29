package org.auvsim.diagnosis.verdict;

import org.auvsim.diagnosis.cause.Cause;
import org.auvsim.diagnosis.fit.Course;
import org.auvsim.diagnosis.fit.Judged;
import org.auvsim.diagnosis.fit.Starts;
import org.auvsim.diagnosis.fit.Uncertainty;
import org.auvsim.diagnosis.search.Search;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/**
 * Decides by the held-out runs between sets of equally many causes that the runs of the fit hardly
 * tell apart. It does not decide between laws of a drag, of which neither need be right, nor
 * whether there is any cause.
 */
final class TieBreak {
    /** Twice the logarithm of the odds from which one is given up for another. */
    private static final double AHEAD = 6;

    /** From which one is given up for good. */
    private static final double FAR_AHEAD = 12;

    private final Trial trial;
    private final Course course;

    TieBreak(Trial trial, Course course) {
        this.trial = trial;
        this.course = course;
    }

    /**
     * A set, and how badly the runs of the fit and those that were held out speak for it together.
     */
    private record Candidate(Judged set, double deviance) {}

    /** What was found, without what held-out runs speak against, if they were asked to the end. */
    Search.Found decided(Search.Found found) {
        List<Judged> others = found.competitors().stream().filter(o -> isIn(found, o)).toList();
        if (others.isEmpty() || !found.best().isWhite()) {
            return found;
        }
        Candidate first = candidate(found.best());
        List<Candidate> rivals = others.stream().map(this::candidate).toList();
        if (!course.goesOn()) {
            return found;
        }
        Candidate best =
                rivals.stream()
                        .filter(rival -> rival.deviance() < first.deviance() - AHEAD)
                        .min(Comparator.comparingDouble(Candidate::deviance))
                        .orElse(first);
        List<Judged> beside = new ArrayList<>(found.competitors());
        beside.addFirst(found.best());
        beside.remove(best.set());
        rivals.stream().filter(rival -> isBeaten(rival, best)).forEach(r -> beside.remove(r.set()));
        if (isBeaten(first, best)) {
            beside.remove(first.set());
        }
        return found.instead(best.set(), List.copyOf(beside));
    }

    /** What is to be said of it: the held-out runs were then more than judges. */
    static List<String> notices(Search.Found before, Search.Found after) {
        List<String> ruledOut =
                Stream.concat(Stream.of(before.best()), before.competitors().stream())
                        .filter(set -> !set.equals(after.best()))
                        .filter(set -> !after.competitors().contains(set))
                        .map(TieBreak::names)
                        .toList();
        if (ruledOut.isEmpty() && before.best().equals(after.best())) {
            return List.of();
        }
        String against =
                ruledOut.isEmpty()
                        ? "for " + names(after.best())
                        : "against " + String.join(" and ", ruledOut);
        return List.of(
                "the runs of the fit hardly tell %s from what else explains them; the held-out runs, which thus took part in the choice, speak %s"
                        .formatted(names(after.best()), against));
    }

    private static String names(Judged set) {
        return set.fit().hypothesis().causes().stream()
                .map(Cause::label)
                .collect(Collectors.joining(" + "));
    }

    private static boolean isBeaten(Candidate one, Candidate best) {
        return one.deviance() > best.deviance() + FAR_AHEAD;
    }

    private static boolean isIn(Search.Found found, Judged other) {
        Judged best = found.best();
        return !other.isNone()
                && other.isWhite()
                && other.fit().hypothesis().causes().size()
                        == best.fit().hypothesis().causes().size()
                && !DragLaw.isAllTheyDifferIn(best, other);
    }

    private Candidate candidate(Judged set) {
        Judged predicted = trial.prediction(set.fit().hypothesis(), course);
        Judged adjusted = Trial.adjusted(set, predicted, new Uncertainty(set).knowledge());
        double share = adjusted.outcome().independent() / adjusted.outcome().count();
        double heldOut = adjusted.outcome().deviance() + Starts.fineness(adjusted.fit());
        return new Candidate(set, set.score() + share * heldOut);
    }
}
