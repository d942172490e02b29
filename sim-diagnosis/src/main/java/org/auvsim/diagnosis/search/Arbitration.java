package org.auvsim.diagnosis.search;

import org.auvsim.diagnosis.fit.Course;
import org.auvsim.diagnosis.fit.Judged;
import org.auvsim.diagnosis.fit.LeaveOneOut;
import org.auvsim.diagnosis.fit.Starts;
import org.auvsim.diagnosis.residual.Misses;
import org.auvsim.diagnosis.run.MeasuredRun;

import java.util.List;

/**
 * Decides between models that explain the runs about equally well: each is fitted to all runs but
 * one, and judged by that one, in turn. What all runs say of them together counts as much: left-out
 * runs alone would take a larger model for a smaller one that is right once in six times, however
 * long they are (Shao, J. American Statistical Association 88, 1993).
 */
final class Arbitration {
    private Arbitration() {}

    /**
     * The model for which left-out runs and all together speak most; the best of the fit, if it is
     * told to stop.
     */
    static Judged decided(Judged best, List<Judged> competitors, Course course) {
        List<MeasuredRun> runs = best.fit().data().stream().map(Misses::run).toList();
        if (competitors.isEmpty() || !LeaveOneOut.canJudge(runs)) {
            return best;
        }
        Judged decided = best;
        double ofBest = leftOut(best, course);
        double least = ofBest;
        for (Judged other : competitors) {
            if (Alternatives.areSame(best, other)) {
                continue; // no run of these tells them apart
            }
            double deviance =
                    Math.max(leftOut(other, course), ofBest - mostGain(best, other))
                            + other.score()
                            - best.score();
            if (deviance < least) {
                least = deviance;
                decided = other;
            }
        }
        return course.goesOn() ? decided : best;
    }

    /**
     * The most that another model may gain of left-out runs: one of more numbers no more than of
     * runs that it was fitted to. Where it seems to, the others leave numbers as they were.
     */
    static double mostGain(Judged best, Judged other) {
        double seen = best.outcome().deviance() - other.outcome().deviance();
        return other.told() > best.told() ? Math.max(0, seen) : Double.POSITIVE_INFINITY;
    }

    /** The deviance of all runs, each by what the others make of the model, whatever its start. */
    private static double leftOut(Judged judged, Course course) {
        double sum = judged.fit().hypothesis().price(); // a cause more has to be worth it here, too
        for (Judged prediction : new LeaveOneOut(judged, course).predictions()) {
            sum += prediction.outcome().deviance() + Starts.fineness(prediction.fit());
        }
        return sum;
    }
}
