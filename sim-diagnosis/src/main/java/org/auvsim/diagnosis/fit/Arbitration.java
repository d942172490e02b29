package org.auvsim.diagnosis.fit;

import org.auvsim.diagnosis.run.MeasuredRun;

import java.util.List;

/**
 * Decides between models that explain the runs about equally well: each is fitted to all runs but
 * one, and judged by that one, in turn.
 */
final class Arbitration {
    private Arbitration() {}

    /** The model that predicts left-out runs best. */
    static Judged decided(Judged best, List<Judged> competitors) {
        List<MeasuredRun> runs = best.fit().data().stream().map(Misses::run).toList();
        if (competitors.isEmpty() || !LeaveOneOut.canJudge(runs)) {
            return best;
        }
        Judged decided = best;
        double least = leftOut(best);
        for (Judged other : competitors) {
            if (Alternatives.areSame(best, other)) {
                continue; // no run of these tells them apart
            }
            double deviance = leftOut(other);
            if (deviance < least) {
                least = deviance;
                decided = other;
            }
        }
        return decided;
    }

    /** The deviance of all runs, each by what the others make of the model, whatever its start. */
    private static double leftOut(Judged judged) {
        double sum = judged.fit().hypothesis().price(); // a cause more has to be worth it here, too
        for (Judged prediction : LeaveOneOut.predictions(judged)) {
            sum += prediction.outcome().deviance() + Starts.fineness(prediction.fit());
        }
        return sum;
    }
}
