package org.auvsim.diagnosis.search;

import org.auvsim.diagnosis.cause.Cause;
import org.auvsim.diagnosis.fit.Course;
import org.auvsim.diagnosis.fit.Hypothesis;
import org.auvsim.diagnosis.fit.Judged;
import org.auvsim.diagnosis.fit.Starts;
import org.auvsim.diagnosis.fit.Uncertainty;

import java.util.Comparator;
import java.util.List;

/**
 * Chooses among sets of causes that explain the runs about as well as the best that was found.
 *
 * @param judged all sets, the best first, those near it with what they ask of the starts
 */
record Choice(List<Judged> judged, List<Cause> library) {
    /** Scores that are worse by more are not looked at again. */
    private static final double NEAR = 30;

    /** Among these, near the best of them that was found. */
    static Choice near(Judged found, List<Judged> judged, List<Cause> library) {
        double usual = Starts.fineness(found.fit());
        double near = found.score() + NEAR;
        return new Choice(
                judged.stream()
                        .map(j -> Alternatives.areSame(found, j) ? asIdle(j, found) : j)
                        .map(j -> j.score() < near ? weighed(j, usual) : j)
                        .sorted(Comparator.comparingDouble(Judged::score))
                        .toList(),
                library);
    }

    /**
     * What predicts the very same as what was found, with no more numbers that leave no trace than
     * that has: those along an axis that is held are not to tell one from the other.
     */
    private static Judged asIdle(Judged same, Judged found) {
        int more = idle(same) - idle(found);
        return more > 0 ? same.telling(same.told() - more) : same;
    }

    private static int idle(Judged of) {
        return of.isNone() ? 0 : of.told() - new Uncertainty(of).told();
    }

    private static Judged weighed(Judged judged, double usual) {
        double more = Starts.fineness(judged.fit()) - usual;
        return Double.isFinite(more) ? judged.dearer(more) : judged;
    }

    /** What is believed, if that was found. */
    Judged instead(Judged found, Course course) {
        Judged best = specific(likeliest(found));
        best = course.goesOn() ? Arbitration.decided(best, competitors(best), course) : best;
        return Alternatives.commonest(best, competitors(best), library);
    }

    /** Sets that explain the runs about as well. */
    List<Judged> competitors(Judged best) {
        return best.isNone() ? List.of() : Alternatives.competitors(best, judged);
    }

    /** The best with the starts taken into account, of those that explain all that was. */
    private Judged likeliest(Judged found) {
        Hypothesis of = found.fit().hypothesis();
        return judged.stream()
                .filter(j -> !j.isNone() && !found.isNone())
                .filter(j -> j.size() <= of.causes().size())
                .filter(j -> of.isGeneric() || !j.fit().hypothesis().isGeneric())
                .filter(j -> j.isWhite() || !found.isWhite())
                .findFirst()
                .orElse(found);
    }

    /** In place of a set that can imitate others, the best of those that explain as much. */
    private Judged specific(Judged best) {
        if (!best.fit().hypothesis().isGeneric()) {
            return best;
        }
        return competitors(best).stream()
                .filter(other -> !other.isNone() && !other.fit().hypothesis().isGeneric())
                .findFirst()
                .orElse(best);
    }
}
