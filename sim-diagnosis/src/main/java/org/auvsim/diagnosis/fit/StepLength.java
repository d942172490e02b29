package org.auvsim.diagnosis.fit;

import org.auvsim.diagnosis.model.BelievedModel;
import org.auvsim.diagnosis.model.Ensemble.Work;
import org.auvsim.diagnosis.residual.Misses;
import org.auvsim.diagnosis.residual.Outcome;
import org.auvsim.diagnosis.shooting.Shooting;
import org.auvsim.diagnosis.shooting.Stepping;
import org.auvsim.diagnosis.shooting.Window;
import org.auvsim.server.feedback.RigidMotion;

import java.util.Arrays;
import java.util.List;
import java.util.function.ToDoubleFunction;
import java.util.stream.IntStream;

/**
 * Finds the steps of a search. The model's are halved until half of them makes no difference that
 * the data could show: else the integrator's error would be taken for a cause. Where that is so at
 * once, predictions take longer ones, which pass samples by, if those make no such difference
 * either and save work; and differences of two motions take longer ones still.
 */
public final class StepLength {
    /**
     * Half the step may move all predictions together by this share of the noise (root of the sum
     * of squares): no parameter is then moved by more of its standard deviation, however many
     * numbers tell it.
     */
    private static final double SHARE = 0.3;

    /** Predictions in longer steps may be moved by that of it. */
    private static final double LONG_SHARE = 0.1;

    /** Steps that do for differences may move each number by so much noise. */
    private static final double ROUGH = 1;

    /** Of steps of differences the engine may cut this share. */
    private static final double FEW_CUTS = 0.1;

    /** Longer steps are worth it if this share of the work is left, or less. */
    private static final double LESS_WORK = 0.9;

    private static final int MOST_HALVINGS = 4;

    private StepLength() {}

    /** The model with steps that are short enough, judged over windows that follow the runs. */
    public static Stepping converged(Fit following) {
        BelievedModel fine = fine(following);
        return withLongerDifferences(
                fine.equals(following.model()) ? passing(fine, following) : Stepping.exact(fine),
                following);
    }

    /** The same with predictions that pass no sample by. */
    public static Stepping atEachSample(Fit following) {
        return withLongerDifferences(Stepping.exact(fine(following)), following);
    }

    private static BelievedModel fine(Fit following) {
        BelievedModel now = following.model();
        for (int h = 0; h < MOST_HALVINGS; h++) {
            Stepping finer = halved(now, following);
            if (all(following, ofDifferences(finer, following)) < SHARE) {
                break;
            }
            now = finer.rough();
        }
        return now;
    }

    private static Stepping halved(BelievedModel model, Fit following) {
        return Stepping.finer(model, step(model, following) / 2);
    }

    /** Whether half of a fit's steps make no difference that the data could show. */
    public static boolean areFine(Fit fit) {
        Stepping finer = halved(fit.stepping().fine(), fit);
        return all(fit, ofDifferences(finer, fit)) < SHARE;
    }

    /** The same model in half of a fit's steps. */
    public static BelievedModel finer(Fit fit) {
        return halved(fit.stepping().fine(), fit).rough();
    }

    /** Predictions that pass samples by; of a body that may touch something none. */
    private static Stepping passing(BelievedModel model, Fit following) {
        Stepping exact = Stepping.exact(model);
        if (!model.touchesNothing()) {
            return exact;
        }
        return leastWork(
                exact,
                Stepping.predictingLonger(model, step(model, following)).stream()
                        .filter(longer -> isMovedByLess(following.in(longer), LONG_SHARE))
                        .toList(),
                following);
    }

    private static Stepping withLongerDifferences(Stepping predicting, Fit following) {
        return leastWork(
                predicting,
                predicting.withLongerDifferences().stream()
                        .filter(
                                longer ->
                                        largest(following, ofDifferences(longer, following))
                                                < ROUGH)
                        .filter(longer -> areHardlyCut(work(longer, following)))
                        .toList(),
                following);
    }

    /**
     * The engine splits steps that are too long for stiff forces, so longer steps may cost as much.
     */
    private static Stepping leastWork(Stepping plain, List<Stepping> longer, Fit following) {
        Stepping best = plain;
        long least = work(plain, following).parts();
        for (Stepping other : longer) {
            long parts = work(other, following).parts();
            if (parts < LESS_WORK * least) {
                best = other;
                least = parts;
            }
        }
        return best;
    }

    /** Motions whose steps are cut otherwise part by more than what moved them. */
    private static boolean areHardlyCut(Work work) {
        return work.cuts() < FEW_CUTS * work.steps();
    }

    /** What the motions of all runs take. */
    private static Work work(Stepping stepping, Fit following) {
        Work sum = Work.NONE;
        for (int r = 0; r < following.data().size(); r++) {
            Shooting shooting = shooting(stepping, following, following.data().get(r));
            for (Window window : following.windows().get(r)) {
                sum = sum.plus(shooting.work(window));
            }
        }
        return sum;
    }

    /** The longest step that is really made: none is longer than the time between samples. */
    private static double step(BelievedModel model, Fit following) {
        double longest = 0;
        for (Misses of : following.data()) {
            for (int k = 1; k < of.run().size(); k++) {
                longest = Math.max(longest, of.run().time(k) - of.run().time(k - 1));
            }
        }
        return Math.min(longest, model.scenario().timeStep().delta());
    }

    /**
     * Whether steps of predictions that pass samples by move none that the data could show, or far
     * less than what is missed anyway.
     */
    public static boolean doFor(Judged of) {
        double beyondNoise = of.isWhite() ? 0 : of.beyondNoise();
        return isMovedByLess(of.fit(), LONG_SHARE * Math.sqrt(Math.max(1, beyondNoise)));
    }

    private static boolean isMovedByLess(Fit fit, double than) {
        return !fit.stepping().passesBy() || all(fit, ofPredictions(fit)) < than;
    }

    /** By what numbers of a window differ in steps of two lengths (standard deviations). */
    @FunctionalInterface
    private interface Distances {
        double[] of(Misses data, Window window);
    }

    /** Predictions from those in fine steps. */
    private static Distances ofPredictions(Fit fit) {
        Stepping fine = Stepping.exact(fit.stepping().fine());
        return (of, window) -> {
            Shooting one = shooting(fine, fit, of);
            Shooting other = shooting(fit.stepping(), fit, of);
            return difference(
                    one.misses(window, one.motion(window)),
                    other.misses(window, other.motion(window)));
        };
    }

    /** Motions in steps of differences from predictions. */
    private static Distances ofDifferences(Stepping stepping, Fit following) {
        return (of, window) -> {
            Shooting shooting = shooting(stepping, following, of);
            RigidMotion[] motion = shooting.motion(window);
            return difference(
                    shooting.misses(window, motion),
                    shooting.misses(window, shooting.rough(window, motion)));
        };
    }

    private static Shooting shooting(Stepping stepping, Fit fit, Misses of) {
        return new Shooting(stepping, fit.variant(), of);
    }

    /** The largest of all windows; infinite where a motion got lost. */
    private static double largest(Fit fit, Distances distances) {
        double largest = 0;
        for (double of : ofWindows(fit, distances, StepLength::largest)) {
            largest = Math.max(largest, of);
        }
        return largest;
    }

    private static double largest(double[] distances) {
        double largest = 0;
        for (double distance : distances) {
            largest =
                    Double.isNaN(distance)
                            ? Double.POSITIVE_INFINITY
                            : Math.max(largest, Math.abs(distance));
        }
        return largest;
    }

    /** The root of the sum of all squares; infinite where a motion got lost. */
    private static double all(Fit fit, Distances distances) {
        double sum = Arrays.stream(ofWindows(fit, distances, Outcome::squares)).sum();
        return Double.isNaN(sum) ? Double.POSITIVE_INFINITY : Math.sqrt(sum);
    }

    private static double[] ofWindows(
            Fit fit, Distances distances, ToDoubleFunction<double[]> measure) {
        return IntStream.range(0, fit.data().size())
                .parallel()
                .mapToObj(
                        r ->
                                fit.windows().get(r).stream()
                                        .map(w -> distances.of(fit.data().get(r), w))
                                        .mapToDouble(measure))
                .flatMapToDouble(ofRun -> ofRun)
                .toArray();
    }

    private static double[] difference(double[] one, double[] other) {
        double[] difference = new double[one.length];
        Arrays.setAll(difference, i -> one[i] - other[i]);
        return difference;
    }
}
