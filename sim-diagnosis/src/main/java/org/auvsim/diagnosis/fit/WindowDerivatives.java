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
    private static final double[] STEPS = {1e-5, 1e-6, 1e-6, 1e-6};

    final Window window;

    /** Of the samples, row by row, in standard deviations. */
    final double[] misses;

    /** Derivative of the misses by each number of the start, and by each parameter. */
    final double[][] byStart;

    final double[][] byParameter;

    /** The window's end, and its derivatives. */
    final RigidMotion end;

    final double[][] endByStart;
    final double[][] endByParameter;

    private WindowDerivatives(
            Misses of,
            Window window,
            boolean isLast,
            List<Entrant> entrants,
            RigidMotion[][] motions,
            double[] steps) {
        this.window = window;
        int samples = window.length() + (isLast ? 1 : 0);
        int parameters = steps.length;
        misses = misses(of, entrants.getFirst(), motions[0], samples);
        end = motions[0][window.length()];
        byStart = new double[RigidMotion.SIZE][];
        endByStart = new double[RigidMotion.SIZE][];
        for (int i = 0; i < RigidMotion.SIZE; i++) {
            RigidMotion[] moved = motions[1 + i];
            byStart[i] =
                    slope(misses(of, entrants.get(1 + i), moved, samples), misses, STEPS[i / 3]);
            endByStart[i] = slope(moved[window.length()].minus(end), STEPS[i / 3]);
        }
        byParameter = new double[parameters][];
        endByParameter = new double[parameters][];
        for (int j = 0; j < parameters; j++) {
            int at = 1 + RigidMotion.SIZE + j;
            RigidMotion[] moved = motions[at];
            byParameter[j] =
                    slope(misses(of, entrants.get(at), moved, samples), misses, steps[j]);
            endByParameter[j] = slope(moved[window.length()].minus(end), steps[j]);
        }
    }

    /**
     * Those of a window under a variant of the model.
     *
     * @param moved variants in which one parameter each is moved by its step
     */
    static WindowDerivatives of(
            BelievedModel model,
            Variant variant,
            Misses of,
            Window window,
            boolean isLast,
            List<Variant> moved,
            double[] steps) {
        List<Entrant> entrants = new ArrayList<>();
        entrants.add(new Entrant(variant, window.start()));
        for (int i = 0; i < RigidMotion.SIZE; i++) {
            double[] by = new double[RigidMotion.SIZE];
            by[i] = STEPS[i / 3];
            entrants.add(new Entrant(variant, window.start().plus(by)));
        }
        for (Variant other : moved) {
            entrants.add(new Entrant(other, window.start()));
        }
        RigidMotion[][] motions =
                Ensemble.simulate(model, of.run(), window.from(), window.to(), entrants);
        return new WindowDerivatives(of, window, isLast, entrants, motions, steps);
    }

    private double[] misses(Misses of, Entrant entrant, RigidMotion[] motions, int samples) {
        return of.of(motions, entrant.variant().sensing(), window.from(), samples);
    }

    private static double[] slope(double[] moved, double[] before, double step) {
        double[] slope = new double[before.length];
        for (int i = 0; i < before.length; i++) {
            slope[i] = (moved[i] - before[i]) / step;
        }
        return slope;
    }

    private static double[] slope(double[] difference, double step) {
        double[] slope = new double[difference.length];
        for (int i = 0; i < difference.length; i++) {
            slope[i] = difference[i] / step;
        }
        return slope;
    }

    /** Sum of the squared misses. */
    double cost() {
        double cost = 0;
        for (double miss : misses) {
            cost += miss * miss;
        }
        return cost;
    }
}
