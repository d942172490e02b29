package org.auvsim.diagnosis.search;

import org.auvsim.diagnosis.cause.Cause;
import org.auvsim.diagnosis.cause.Guess;
import org.auvsim.diagnosis.fit.Course;
import org.auvsim.diagnosis.fit.Hypothesis;
import org.auvsim.diagnosis.fit.Judged;
import org.auvsim.diagnosis.residual.Noise;

import java.util.List;

/**
 * Tries what was found at all frequencies that look alike to each run by itself. Of runs at
 * different times of one clock a frequency that is a little off shifts the phase in each by
 * something else: so a search that begins at few of them ends at the alias next to it.
 */
record Aliasing(Screening screening, Noise noise, Course course) {
    private static final double FROM = 0.8;
    private static final double TO = 0.85;

    /** The best of those, if it is better than what was found and misses something. */
    Judged undone(Judged found) {
        Judged best = found;
        for (int c = 0; c < found.size(); c++) {
            Hypothesis of = found.fit().hypothesis();
            Cause cause = of.causes().get(c);
            List<Guess> aliases = cause.aliases(of.theta().get(c));
            if (!aliases.isEmpty() && !best.isWhite() && course.goesOn()) {
                best = better(screening.beside(of.without(c), cause, aliases), best);
            }
        }
        return best;
    }

    private Judged better(Screen screen, Judged found) {
        Tournament tournament = new Tournament(found, noise, course, FROM, TO);
        return Tried.best(tournament.last(screen.starts(1, _ -> true)), found);
    }
}
