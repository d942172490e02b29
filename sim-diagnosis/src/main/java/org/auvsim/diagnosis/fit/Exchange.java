package org.auvsim.diagnosis.fit;

import org.auvsim.diagnosis.cause.Cause;

import java.util.ArrayList;
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

    /**
     * The best. A specific cause stays before a generic one that fits about as well, which is told
     * beside it.
     */
    Judged best(Judged found, Traces traces) {
        Judged best = found;
        Hypothesis of = found.fit().hypothesis();
        for (int c = 0; c < of.causes().size() && course.goesOn(); c++) {
            List<Screen.Start> starts = insteadOf(c, found, traces.alike(of.causes().get(c)));
            if (!starts.isEmpty()) {
                Judged other = tried.tournament(starts, best, 0.8, 0.9);
                boolean isAsGood = of.isGeneric() || !other.fit().hypothesis().isGeneric();
                boolean isClear = best.score() - other.score() > Selection.DOUBTFUL;
                best = !other.equals(best) && (isAsGood || isClear) ? tried.pruned(other) : best;
            }
        }
        return best;
    }

    /**
     * Sets that were not judged yet: others with an alias of a cause, or with what promises most.
     * Aliases are tried again whose fits ended far from it: they got lost. What leaves noise alone
     * did not stand for what swings.
     */
    private List<Screen.Start> insteadOf(int of, Judged found, List<Cause> aliases) {
        Hypothesis others = found.fit().hypothesis().without(of);
        List<Cause> lost =
                aliases.stream()
                        .filter(o -> !others.causes().contains(o))
                        .filter(o -> !tried.has(others, o, found.score() + Tournament.BESIDE))
                        .toList();
        List<Screen.Start> starts = new ArrayList<>(promising(others, lost, found));
        if (!others.causes().isEmpty()) {
            List<Cause> untried =
                    library.stream()
                            .filter(o -> !found.fit().hypothesis().causes().contains(o))
                            .filter(o -> !aliases.contains(o))
                            .filter(o -> !found.isWhite() || !screening.isSwept(o))
                            .filter(o -> !tried.has(others, o, Double.POSITIVE_INFINITY))
                            .toList();
            promising(others, untried, found).stream().limit(MOST).forEach(starts::add);
        }
        return starts;
    }

    private List<Screen.Start> promising(Hypothesis beside, List<Cause> causes, Judged found) {
        return causes.isEmpty()
                ? List.of()
                : Screening.promising(screening.beside(beside, causes, found));
    }
}
