package org.auvsim.diagnosis.fit;

import org.auvsim.diagnosis.model.BelievedModel;
import org.auvsim.diagnosis.model.Ensemble;
import org.auvsim.diagnosis.model.Ensemble.Entrant;
import org.auvsim.diagnosis.model.Variant;
import org.auvsim.server.feedback.RigidMotion;

import java.util.ArrayList;
import java.util.List;

/**
 * What a window misses of the measurement, and how that and its end depend on its start and on
 * parameters of causes, by differences: one simulation each, all side by side (Bock 1981).
 */
final class WindowDerivatives {
    /** Changes of a start: position (m), turn (rad), velocity (m/s), angular velocity (rad/s). */
    static final double[] STEPS = {1e-5, 1e-6, 1e-6, 1e-6};

    final Window window;

    /** Of the samples, row by row, in standard deviations. */
    final double[] misses;

    /** Derivative of the misses by each number of the start, and by each parameter. */
    final double[][] byStart;

    final double[][] byParameter;

    /** At each sample, the first of the next window included. */
    final RigidMotion[] motion;

    /** The window's end, and its derivatives. */
    final RigidMotion end;

    final double[][] endByStart;
    final double[][] endByParameter;

    /**
     * What is moved to find derivatives by parameters.
     *
     * @param variants the model with one parameter moved, each
     * @param steps by how much
     */
    record Moves(List<Variant> variants, List<Double> steps) {
        static final Moves NONE = new Moves(List.of(), List.of());

        /** How many parameters are moved. */
        int size() {
            return steps.size();
        }
    }

    private WindowDerivatives(
            Misses of,
            Window window,
            boolean isLast,
            int group,
            List<Entrant> entrants,
            RigidMotion[][] motions,
            List<Double> steps) {
        this.window = window;
        int samples = window.length() + (isLast ? 1 : 0);
        double[][] all = new double[motions.length][];
        for (int i = 0; i < motions.length; i++) {
            all[i] =
                    of.of(
                            motions[i],
                            entrants.get(i).variant().sensing(),
                            window.from(),
                            samples,
                            group);
        }
        misses = all[0];
        motion = motions[0];
        end = motion[window.length()];
        byStart = new double[RigidMotion.SIZE][];
        endByStart = new double[RigidMotion.SIZE][];
        byParameter = new double[steps.size()][];
        endByParameter = new double[steps.size()][];
        for (int i = 1; i < motions.length; i++) {
            int p = i - 1 - RigidMotion.SIZE;
            double step = p < 0 ? STEPS[(i - 1) / 3] : steps.get(p);
            double[] slope = slope(all[i], misses, step);
            double[] endSlope = slope(motions[i][window.length()].minus(end), step);
            if (p < 0) {
                byStart[i - 1] = slope;
                endByStart[i - 1] = endSlope;
            } else {
                byParameter[p] = slope;
                endByParameter[p] = endSlope;
            }
        }
    }

    private WindowDerivatives(
            WindowDerivatives of, double[][] byParameter, double[][] endByParameter) {
        window = of.window;
        misses = of.misses;
        byStart = of.byStart;
        motion = of.motion;
        end = of.end;
        endByStart = of.endByStart;
        this.byParameter = byParameter;
        this.endByParameter = endByParameter;
    }

    /** The same with derivatives by other parameters. */
    WindowDerivatives by(double[][] byParameter, double[][] endByParameter) {
        return new WindowDerivatives(this, byParameter, endByParameter);
    }

    /**
     * Those of a window under a variant of the model.
     *
     * @param isLast whether it is the last of its run, and so has the run's last sample
     * @param group how many samples are taken together
     */
    static WindowDerivatives of(
            BelievedModel model,
            Variant variant,
            Misses of,
            Window window,
            boolean isLast,
            int group,
            Moves moves) {
        List<Entrant> entrants = new ArrayList<>();
        for (RigidMotion start : starts(model, window.start())) {
            entrants.add(new Entrant(variant, start));
        }
        for (Variant other : moves.variants()) {
            entrants.add(new Entrant(other, window.start()));
        }
        RigidMotion[][] motions =
                Ensemble.simulate(model, of.run(), window.from(), window.to(), entrants);
        return new WindowDerivatives(of, window, isLast, group, entrants, motions, moves.steps());
    }

    /** A start, then the same with each of its numbers moved. */
    static List<RigidMotion> starts(BelievedModel model, RigidMotion start) {
        List<RigidMotion> starts = new ArrayList<>();
        starts.add(start);
        for (int i = 0; i < RigidMotion.SIZE; i++) {
            double[] by = new double[RigidMotion.SIZE];
            by[i] = STEPS[i / 3];
            starts.add(start.plus(model.free(by)));
        }
        return starts;
    }

    /** Differences over a step; 0 if what was moved got lost: nothing is known of it. */
    static double[] slope(double[] moved, double[] before, double step) {
        double[] slope = new double[before.length];
        for (int i = 0; i < before.length; i++) {
            slope[i] = (moved[i] - before[i]) / step;
            if (Double.isNaN(slope[i])) {
                return new double[before.length];
            }
        }
        return slope;
    }

    private static double[] slope(double[] difference, double step) {
        return slope(difference, new double[difference.length], step);
    }

    /** Whether its motion got out of all bounds. */
    boolean isLost() {
        return Double.isNaN(end.position().x());
    }

    /** Sum of the squared misses. */
    double cost() {
        double cost = 0;
        for (double miss : misses) {
            cost += miss * miss;
        }
        return Double.isNaN(cost) ? Double.POSITIVE_INFINITY : cost;
    }
}
