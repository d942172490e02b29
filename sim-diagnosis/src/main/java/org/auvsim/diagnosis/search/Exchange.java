package org.auvsim.diagnosis.search;

import org.auvsim.diagnosis.cause.Cause;
import org.auvsim.diagnosis.fit.Course;
import org.auvsim.diagnosis.fit.Hypothesis;
import org.auvsim.diagnosis.fit.Judged;

import java.util.List;

/**
 * Exchanges each cause that was found for those that leave nearly the same trace: which of two it
 * is that the data cannot tell apart is not to depend on which was tried. Beside others it is
 * exchanged for the most promising ones, too: it may have been found before them, and have stood
 * for them.
 */
record Exchange(List<Cause> library, Screening screening, Tried tried, Course course) {
    /** So many of the most promising ones. */
    private static final int MOST = 4;

    /** Scores of aliases differ by no more, unless a fit got lost. */
    private static final double ALIKE = 2;

    /**
     * The best. A specific cause stays before a generic one that fits about as well, which is told
     * beside it.
     */
    Judged best(Judged found, Traces traces) {
        Judged best = found;
        Hypothesis of = found.fit().hypothesis();
        for (int c = 0; c < of.causes().size() && course.goesOn(); c++) {
            List<Cause> aliases = traces.alike(of.causes().get(c));
            Judged other = tried.tournament(untried(c, found, aliases), best, 0.8, 0.9);
            other = tried.tournamentAnew(lost(c, found, aliases), other, 0.8, 0.9);
            boolean isAsGood = of.isGeneric() || !other.fit().hypothesis().isGeneric();
            boolean isClear = best.score() - other.score() > OneOrTwo.DOUBTFUL;
            best = !other.equals(best) && (isAsGood || isClear) ? tried.pruned(other) : best;
        }
        return best;
    }

    /** Others with an alias of a cause whose fit ended far from it: it got lost. */
    private List<Screen.Start> lost(int of, Judged found, List<Cause> aliases) {
        Hypothesis others = found.fit().hypothesis().without(of);
        List<Cause> lost =
                aliases.stream()
                        .filter(o -> !o.isAmong(others.causes()))
                        .filter(o -> !tried.has(others, o, found.score() + ALIKE))
                        .toList();
        return promising(others, lost, found);
    }

    /**
     * Others with what promises most and was not judged yet. What leaves noise alone did not stand
     * for what swings, unless it swings, too.
     */
    private List<Screen.Start> untried(int of, Judged found, List<Cause> aliases) {
        Hypothesis others = found.fit().hypothesis().without(of);
        if (others.causes().isEmpty()) {
            return List.of();
        }
        Cause exchanged = found.fit().hypothesis().causes().get(of);
        boolean maySwing = !found.isWhite() || screening.isSwept(exchanged);
        List<Cause> untried =
                library.stream()
                        .filter(o -> !o.isAmong(found.fit().hypothesis().causes()))
                        .filter(o -> !aliases.contains(o))
                        .filter(o -> maySwing || !screening.isSwept(o))
                        .filter(o -> !tried.has(others, o, Double.POSITIVE_INFINITY))
                        .toList();
        return promising(others, untried, found).stream().limit(MOST).toList();
    }

    private List<Screen.Start> promising(Hypothesis beside, List<Cause> causes, Judged found) {
        return causes.isEmpty()
                ? List.of()
                : Screening.promising(screening.beside(beside, causes, found));
    }
}
