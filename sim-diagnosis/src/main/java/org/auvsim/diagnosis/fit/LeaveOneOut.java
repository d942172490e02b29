package org.auvsim.diagnosis.fit;

import org.auvsim.diagnosis.residual.Misses;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.shooting.Window;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;

/** Judges a model where all runs were searched with: each is predicted by what the others say. */
public final class LeaveOneOut {
    private static final int STEPS = 6;

    /** Twice the logarithm of a likelihood grows by more for a number two deviations off. */
    private static final double CHANCE = 4;

    private final Judged judged;
    private final Course course;

    /** By run: fitted to all others. */
    private final List<Judged> others = new ArrayList<>();

    /** By run: predicted by that. */
    private final List<Judged> predictions = new ArrayList<>();

    /**
     * Of a model that was fitted to all runs.
     *
     * @param course once it was told to stop, some are as all runs together have it
     */
    public LeaveOneOut(Judged judged, Course course) {
        this.judged = judged;
        this.course = course;
    }

    /**
     * Whether runs can judge one another. Parts of one run whose start is known cannot: what that
     * shows, as the zero of a sensor, the first of them tells alone.
     */
    public static boolean canJudge(List<MeasuredRun> runs) {
        MeasuredRun first = runs.getFirst().uncut();
        return runs.size() > 1
                && (first.start().isEmpty()
                        || runs.stream().anyMatch(run -> !run.uncut().equals(first)));
    }

    /** The hypothesis as fitted to all runs but one, and that one predicted by it, for each. */
    public List<Judged> predictions() {
        while (predictions.size() < runs()) {
            int run = predictions.size();
            Fit alone = judged.fit().ofRun(run);
            predictions.add(converged(alone.with(ofOthers(run).settled(), alone.windows())));
        }
        return List.copyOf(predictions);
    }

    /**
     * The same, but its parameters may move within what the others leave open: a run may tell more
     * of them than all others.
     */
    public List<Judged> adjusted() {
        List<Judged> predictions = new ArrayList<>();
        for (int r = 0; r < runs(); r++) {
            Hypothesis hypothesis = others(r).fit().hypothesis();
            Knowledge known = new Uncertainty(others(r)).knowledge();
            Fit alone = judged.fit().ofRun(r);
            predictions.add(converged(alone.with(hypothesis, alone.windows()).knowing(known)));
        }
        return predictions;
    }

    /**
     * Whether one run alone asks for more than a model with fewer causes has: without that, all
     * others together do not.
     */
    public boolean restsOnOneRun(LeaveOneOut fewer) {
        return IntStream.range(0, runs()).anyMatch(run -> gain(run, fewer) < CHANCE);
    }

    /** By how much twice the logarithm of the likelihood of all runs but one is more. */
    private double gain(int run, LeaveOneOut fewer) {
        return fewer.others(run).outcome().deviance() - others(run).outcome().deviance();
    }

    private int runs() {
        return judged.fit().data().size();
    }

    /** The hypothesis as all runs but one have it. */
    private Hypothesis ofOthers(int run) {
        Hypothesis ofAll = judged.fit().hypothesis();
        return ofAll.size() == 0 ? ofAll : others(run).fit().hypothesis();
    }

    private Judged others(int run) {
        while (others.size() <= run) {
            others.add(converged(without(judged.fit(), others.size())));
        }
        return others.get(run);
    }

    private Judged converged(Fit fit) {
        return Descent.of(fit).steps(STEPS, Double.POSITIVE_INFINITY, course);
    }

    private static Fit without(Fit fit, int run) {
        List<Misses> data = new ArrayList<>(fit.data());
        List<List<Window>> windows = new ArrayList<>(fit.windows());
        data.remove(run);
        windows.remove(run);
        return new Fit(fit.stepping(), data, fit.hypothesis(), windows, fit.knowledge());
    }
}
