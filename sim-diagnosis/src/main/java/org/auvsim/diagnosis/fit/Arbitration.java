package org.auvsim.diagnosis.fit;

import java.util.ArrayList;
import java.util.List;

/**
 * Decides between models that explain the runs about equally well: each is fitted to all runs but
 * one, and judged by that one, in turn.
 */
final class Arbitration {
    private static final int STEPS = 6;

    private Arbitration() {}

    /** The model that predicts left-out runs best. */
    static Judged decided(Judged best, List<Judged> competitors) {
        if (competitors.isEmpty() || best.fit().data().size() < 2) {
            return best;
        }
        Judged decided = best;
        double least = leftOut(best);
        for (Judged other : competitors) {
            double deviance = leftOut(other);
            if (deviance < least) {
                least = deviance;
                decided = other;
            }
        }
        return decided;
    }

    /** The deviance of all runs, each by what the others make of the model. */
    private static double leftOut(Judged judged) {
        double sum = price(judged);
        for (int r = 0; r < judged.fit().data().size(); r++) {
            Judged others = Refinement.converge(Judged.of(without(judged.fit(), r)), STEPS);
            Hypothesis settled = others.fit().hypothesis().settled();
            Fit alone = only(judged.fit(), r).with(settled, only(judged.fit(), r).windows());
            sum += Refinement.converge(Judged.of(alone), STEPS).outcome().deviance();
        }
        return sum;
    }

    /** A cause more has to be worth its price here, too. */
    private static double price(Judged judged) {
        return Judged.PER_CAUSE * judged.fit().hypothesis().causes().size();
    }

    private static Fit without(Fit fit, int run) {
        List<Misses> data = new ArrayList<>(fit.data());
        List<List<Window>> windows = new ArrayList<>(fit.windows());
        data.remove(run);
        windows.remove(run);
        return new Fit(fit.model(), data, fit.hypothesis(), windows, fit.knowledge());
    }

    private static Fit only(Fit fit, int run) {
        return new Fit(
                fit.model(),
                List.of(fit.data().get(run)),
                fit.hypothesis(),
                List.of(fit.windows().get(run)),
                fit.knowledge());
    }
}
