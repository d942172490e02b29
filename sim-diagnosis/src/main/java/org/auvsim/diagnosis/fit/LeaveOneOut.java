package org.auvsim.diagnosis.fit;

import org.auvsim.diagnosis.fit.Outcome.Squares;
import org.auvsim.diagnosis.run.Channel;
import org.auvsim.diagnosis.run.MeasuredRun;

import java.util.ArrayList;
import java.util.List;

/** Judges a model where all runs were searched with: each is predicted by what the others say. */
final class LeaveOneOut {
    private static final int STEPS = 6;

    private LeaveOneOut() {}

    /**
     * Whether runs can judge one another. Parts of one run whose start is known cannot: what that
     * shows, as the zero of a sensor, the first of them tells alone.
     */
    static boolean canJudge(List<MeasuredRun> runs) {
        MeasuredRun first = runs.getFirst().whole();
        return runs.size() > 1
                && (first.start().isEmpty()
                        || runs.stream().anyMatch(run -> !run.whole().equals(first)));
    }

    /**
     * The hypothesis as fitted to all runs but one, and that one predicted by it, for each; told to
     * stop, some as all runs together have it.
     */
    static List<Judged> predictions(Judged judged, Course course) {
        List<Judged> predictions = new ArrayList<>();
        for (int r = 0; r < judged.fit().data().size(); r++) {
            Judged others = converged(without(judged.fit(), r), course);
            Fit alone = only(judged.fit(), r);
            Fit settled = alone.with(others.fit().hypothesis().settled(), alone.windows());
            predictions.add(converged(settled, course));
        }
        return predictions;
    }

    /**
     * The same, but its parameters may move within what the others leave open: a run may tell more
     * of them than all others.
     */
    static List<Judged> adjusted(Judged judged, Course course) {
        List<Judged> predictions = new ArrayList<>();
        for (int r = 0; r < judged.fit().data().size(); r++) {
            Judged others = converged(without(judged.fit(), r), course);
            Knowledge known = new Uncertainty(others).knowledge();
            Fit alone = only(judged.fit(), r);
            Fit open = alone.with(others.fit().hypothesis(), alone.windows()).knowing(known);
            predictions.add(converged(open, course));
        }
        return predictions;
    }

    private static Judged converged(Fit fit, Course course) {
        return Refinement.converge(Judged.of(fit), STEPS, Double.POSITIVE_INFINITY, course);
    }

    /** Root mean square error of a channel over all predictions, in its unit. */
    static double error(List<Judged> predictions, Channel channel) {
        double sum = 0;
        int count = 0;
        for (Judged prediction : predictions) {
            Squares errors = prediction.fit().errors().getOrDefault(channel, Outcome.NOTHING);
            sum += errors.sum();
            count += errors.count();
        }
        return Math.sqrt(sum / count);
    }

    private static Fit without(Fit fit, int run) {
        List<Misses> data = new ArrayList<>(fit.data());
        List<List<Window>> windows = new ArrayList<>(fit.windows());
        data.remove(run);
        windows.remove(run);
        return new Fit(fit.stepping(), data, fit.hypothesis(), windows, fit.knowledge());
    }

    private static Fit only(Fit fit, int run) {
        return new Fit(
                fit.stepping(),
                List.of(fit.data().get(run)),
                fit.hypothesis(),
                List.of(fit.windows().get(run)),
                fit.knowledge());
    }
}
