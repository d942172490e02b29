package org.auvsim.diagnosis.verdict;

import org.apache.commons.math3.util.MathArrays;
import org.auvsim.diagnosis.cause.Cause;
import org.auvsim.diagnosis.fit.Course;
import org.auvsim.diagnosis.fit.Descent;
import org.auvsim.diagnosis.fit.Fit;
import org.auvsim.diagnosis.fit.Following;
import org.auvsim.diagnosis.fit.Hypothesis;
import org.auvsim.diagnosis.fit.Judged;
import org.auvsim.diagnosis.fit.Knowledge;
import org.auvsim.diagnosis.fit.LeaveOneOut;
import org.auvsim.diagnosis.fit.Refinement;
import org.auvsim.diagnosis.model.Variant;
import org.auvsim.diagnosis.residual.Misses;
import org.auvsim.diagnosis.residual.Noise;
import org.auvsim.diagnosis.residual.Outcome;
import org.auvsim.diagnosis.result.HorizonGain;
import org.auvsim.diagnosis.run.Channel;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.shooting.Stepping;

import java.util.List;
import java.util.stream.IntStream;
import java.util.stream.Stream;

/** Held-out runs judge a hypothesis, which had no part in choosing it. */
final class Trial {
    private static final int STEPS = 12;

    /** A channel may be missed by so many times what it is missed by in the runs of the fit. */
    private static final double MOST_RATIO = 1.3;

    private final Stepping stepping;
    private final List<Misses> data;
    private final Noise noise;

    Trial(Stepping stepping, List<MeasuredRun> heldOut, Noise noise) {
        this.stepping = stepping;
        this.data = Misses.of(heldOut, noise);
        this.noise = noise;
    }

    /** Held-out runs from starts of their own, the hypothesis as it is. */
    Judged prediction(Hypothesis hypothesis) {
        return prediction(hypothesis, Course.UNHEARD);
    }

    /** The same, as far as it has come once it was told to stop. */
    Judged prediction(Hypothesis hypothesis, Course course) {
        Fit fit = Following.of(stepping, hypothesis.settled(), data, noise, course);
        Judged near = Refinement.approach(fit, 1, Double.POSITIVE_INFINITY, course).judged();
        return begunAnew(arrived(near, course), course);
    }

    private static Judged arrived(Judged near, Course course) {
        return Descent.of(near).steps(STEPS, Double.POSITIVE_INFINITY, course);
    }

    /** From new starts of the runs, if it misses something and less from there. */
    private Judged begunAnew(Judged of, Course course) {
        if (of.isWhite() || !course.goesOn()) {
            return of;
        }
        Judged anew = arrived(Judged.of(Following.anew(of.fit(), noise, course)), course);
        return anew.cost() < of.cost() ? anew : of;
    }

    /**
     * What was predicted, the parameters moved within what the runs of the fit leave open: on a
     * long or tumbling run that makes all the difference.
     *
     * @param known of the parameters by the fit
     */
    static Judged adjusted(Judged fitted, Judged predicted, Knowledge known) {
        Fit fit = predicted.fit().with(fitted.fit().hypothesis(), predicted.fit().windows());
        return Descent.of(fit.knowing(known)).steps(STEPS);
    }

    /**
     * Whether a hypothesis holds on the held-out runs, adjusted to them. One that predicts them
     * worse than the model as it was believed does not hold, adjusted or as it is: what only fitted
     * noise can often be moved to fit other noise.
     *
     * @param before the model as it was believed, on the held-out runs
     * @param predicted the hypothesis as it is on them
     * @param adjusted the same, adjusted
     */
    static boolean passes(Judged fitted, Judged before, Judged predicted, Judged adjusted) {
        double worst = before.outcome().deviance() + Cause.PRICE;
        return isConfirmed(before, List.of(adjusted), fitted)
                && predicted.outcome().deviance() < worst
                && adjusted.outcome().deviance() < worst
                && holds(adjusted, fitted);
    }

    /**
     * Whether each of the runs that all were searched with is predicted by the others, and not one
     * of them alone asks for the causes.
     *
     * @param none the model as it was believed, fitted to the same runs
     * @param turns of what was fitted
     */
    static boolean holdsLeftOut(Judged none, Judged fitted, LeaveOneOut turns) {
        List<Judged> predictions = turns.adjusted();
        return !restsOnOneRun(none, fitted)
                && isConfirmed(none, predictions, fitted)
                && predictions.stream().allMatch(prediction -> holds(prediction, fitted));
    }

    /** Whether what is missed of other runs, parameters held to what the fit says, is noise. */
    private static boolean holds(Judged prediction, Judged fitted) {
        return prediction.isWhite()
                && worstRatio(prediction.outcome(), fitted.outcome()) < MOST_RATIO;
    }

    /** Whether causes would not be worth their price without the run that gains most by them. */
    private static boolean restsOnOneRun(Judged none, Judged fitted) {
        double all = 0;
        double most = 0;
        for (int r = 0; r < fitted.fit().data().size(); r++) {
            double gain =
                    Outcome.squares(none.outcome().misses().get(r))
                            - Outcome.squares(fitted.outcome().misses().get(r));
            all += gain;
            most = Math.max(most, gain);
        }
        return all - most < fitted.price();
    }

    /** A model that lacks nothing has nothing to be borne out. */
    private static boolean isConfirmed(Judged before, List<Judged> predictions, Judged fitted) {
        List<double[]> after = predictions.stream().flatMap(Trial::missed).toList();
        int parameters = predictions.size() * fitted.fit().hypothesis().size();
        return fitted.isNone() || Confirmation.of(missed(before).toList(), after, parameters);
    }

    /**
     * What is missed of each run: the measurements, and what is known of its start, which alone
     * tells the zero of a sensor.
     */
    private static Stream<double[]> missed(Judged judged) {
        Fit fit = judged.fit();
        List<double[]> misses = judged.outcome().misses();
        return IntStream.range(0, misses.size())
                .mapToObj(r -> MathArrays.concatenate(misses.get(r), fit.startMisses(r)));
    }

    /** The largest ratio over channels of root mean squares. */
    private static double worstRatio(Outcome heldOut, Outcome fitted) {
        double worst = 0;
        for (Channel channel : heldOut.squares().keySet()) {
            if (fitted.of(channel).count() > 0) {
                double ratio = heldOut.of(channel).mean() / fitted.expected(channel);
                worst = Math.max(worst, Math.sqrt(ratio));
            }
        }
        return Double.isFinite(heldOut.cost()) ? worst : Double.POSITIVE_INFINITY;
    }

    /** Errors by how far ahead a variant predicts the runs, as a prediction sees them. */
    List<HorizonGain> horizons(Judged prediction, Variant after) {
        return new Horizons(stepping, noise).gains(prediction.fit().data(), after);
    }
}
