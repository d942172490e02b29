package org.auvsim.diagnosis.fit;

import org.auvsim.diagnosis.cause.Cause;
import org.auvsim.diagnosis.model.BelievedModel;
import org.auvsim.diagnosis.model.Ensemble;
import org.auvsim.diagnosis.model.Ensemble.Entrant;
import org.auvsim.diagnosis.model.Variant;
import org.auvsim.diagnosis.run.MeasuredRun;
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

    /** Share of a parameter's scale. */
    private static final double SHARE = 1e-3;

    final Window window;

    /** Misses of the samples, {@value Weights#ROWS} rows each, in standard deviations. */
    final double[] misses;

    /** Derivative of the misses by each number of the start, and by each parameter. */
    final double[][] byStart;

    final double[][] byParameter;

    /** The window's end, and its derivatives. */
    final RigidMotion end;

    final double[][] endByStart;
    final double[][] endByParameter;

    /** A column of the library: one parameter of one cause. */
    record Column(Cause cause, int parameter) {
        Variant shifted(Variant variant, double by) {
            double[] theta = new double[cause.parameters().size()];
            theta[parameter] = by;
            return cause.in(variant, theta);
        }

        double step() {
            return SHARE * cause.parameters().get(parameter).scale();
        }
    }

    private WindowDerivatives(
            MeasuredRun run,
            Weights weights,
            Window window,
            boolean isLast,
            RigidMotion[][] motions,
            List<Column> columns) {
        this.window = window;
        int samples = window.length() + (isLast ? 1 : 0);
        misses = misses(run, weights, motions[0], samples);
        end = motions[0][window.length()];
        byStart = new double[RigidMotion.SIZE][];
        endByStart = new double[RigidMotion.SIZE][];
        for (int i = 0; i < RigidMotion.SIZE; i++) {
            RigidMotion[] moved = motions[1 + i];
            byStart[i] = slope(misses(run, weights, moved, samples), misses, STEPS[i / 3]);
            endByStart[i] = slope(moved[window.length()].minus(end), STEPS[i / 3]);
        }
        byParameter = new double[columns.size()][];
        endByParameter = new double[columns.size()][];
        for (int j = 0; j < columns.size(); j++) {
            RigidMotion[] moved = motions[1 + RigidMotion.SIZE + j];
            double step = columns.get(j).step();
            byParameter[j] = slope(misses(run, weights, moved, samples), misses, step);
            endByParameter[j] = slope(moved[window.length()].minus(end), step);
        }
    }

    /** Those of a window under a variant of the model. */
    static WindowDerivatives of(
            BelievedModel model,
            Variant variant,
            MeasuredRun run,
            Weights weights,
            Window window,
            boolean isLast,
            List<Column> columns) {
        List<Entrant> entrants = new ArrayList<>();
        entrants.add(new Entrant(variant, window.start()));
        for (int i = 0; i < RigidMotion.SIZE; i++) {
            double[] by = new double[RigidMotion.SIZE];
            by[i] = STEPS[i / 3];
            entrants.add(new Entrant(variant, window.start().plus(by)));
        }
        for (Column column : columns) {
            entrants.add(new Entrant(column.shifted(variant, column.step()), window.start()));
        }
        RigidMotion[][] motions =
                Ensemble.simulate(model, run, window.from(), window.to(), entrants);
        return new WindowDerivatives(run, weights, window, isLast, motions, columns);
    }

    private double[] misses(
            MeasuredRun run, Weights weights, RigidMotion[] motions, int samples) {
        double[] misses = new double[samples * Weights.ROWS];
        for (int k = 0; k < samples; k++) {
            weights.residuals(
                    run.samples().get(window.from() + k), motions[k], misses, k * Weights.ROWS);
        }
        return misses;
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
