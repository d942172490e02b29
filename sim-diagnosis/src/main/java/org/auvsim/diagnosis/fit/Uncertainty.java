package org.auvsim.diagnosis.fit;

import org.apache.commons.math3.linear.Array2DRowRealMatrix;
import org.apache.commons.math3.linear.LUDecomposition;
import org.apache.commons.math3.linear.RealMatrix;
import org.auvsim.diagnosis.cause.Cause;
import org.auvsim.diagnosis.cause.Parameter;
import org.auvsim.diagnosis.cause.Quantity;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;

/**
 * How well the parameters of a fit are determined: the covariance at its optimum, and what the
 * profile of the likelihood makes of it.
 */
public final class Uncertainty {
    /**
     * Regularises the scaled information: two parameters with identical traces get deviations
     * larger by a factor of about 1/sqrt(2 RIDGE).
     */
    private static final double RIDGE = 1e-10;

    /** A quantity that changes by less than this share of itself does so by rounding alone. */
    private static final double UNCHANGED = 1e-6;

    /** Of its scale, a number that does not show at so much is not told. */
    private static final double SLIGHTEST = 1e6;

    /** By so much (rad) at most a phase is turned to see how it changes. */
    private static final double SLIGHT_TURN = 0.1;

    private final Judged fitted;
    private final Tangents tangents;
    private final double[][] information;
    private final double excess;

    /** That of a fit that has converged. */
    public Uncertainty(Judged fitted) {
        this.fitted = fitted;
        Fit fit = fitted.fit();
        int size = fit.hypothesis().size();
        int[] all = IntStream.range(0, size).toArray();
        tangents = Tangents.close(Simulated.of(fit));
        Gram gram = Gram.of(fit.blocks(tangents.derivatives(), 1), size);
        information = gram.information(all);
        forgetRounding(fit.hypothesis().parameters());
        excess = Math.max(1, fitted.cost() / fitted.outcome().count());
        for (double[] row : information) {
            for (int i = 0; i < row.length; i++) {
                row[i] /= excess;
            }
        }
    }

    /** What hardly shows at a million times its scale leaves no trace but of rounding. */
    private void forgetRounding(List<Parameter> parameters) {
        for (int i = 0; i < information.length; i++) {
            double shown = SLIGHTEST * parameters.get(i).scale();
            if (information[i][i] * shown * shown < 1) {
                for (int j = 0; j < information.length; j++) {
                    information[i][j] = 0;
                    information[j][i] = 0;
                }
            }
        }
    }

    /** How many of its numbers leave a trace in the runs. */
    public int told() {
        return (int) IntStream.range(0, information.length).filter(this::leavesATrace).count();
    }

    private boolean leavesATrace(int number) {
        return information[number][number] > 0;
    }

    /** What the fit says of its parameters to whoever looks at other runs. */
    public Knowledge knowledge() {
        return new Knowledge(fitted.fit().hypothesis().numbers(), information);
    }

    /**
     * The inverse, each number in its own standard deviation, so that units do not matter: what
     * hardly differs from another's trace is then uncertain, where a pseudo-inverse has it exact. 0
     * where a number leaves no trace: it makes no other uncertain.
     */
    private RealMatrix covariance() {
        int size = information.length;
        double[] scale = new double[size];
        for (int i = 0; i < size; i++) {
            scale[i] = information[i][i] > 0 ? 1 / Math.sqrt(information[i][i]) : 0;
        }
        RealMatrix scaled = new Array2DRowRealMatrix(size, size);
        for (int i = 0; i < size; i++) {
            for (int j = 0; j < size; j++) {
                scaled.setEntry(i, j, information[i][j] * scale[i] * scale[j]);
            }
            scaled.setEntry(i, i, 1 + RIDGE);
        }
        RealMatrix inverse = new LUDecomposition(scaled).getSolver().getInverse();
        for (int i = 0; i < size; i++) {
            for (int j = 0; j < size; j++) {
                inverse.multiplyEntry(i, j, scale[i] * scale[j]);
            }
        }
        return inverse;
    }

    /**
     * Standard deviations of the quantities of all causes, as profiled; NaN of those that depend on
     * a number that leaves no trace.
     */
    public List<List<Double>> deviations() {
        RealMatrix covariance = covariance();
        double[] stretches = new Profile(fitted, tangents, covariance, excess).stretches();
        for (int i = 0; i < stretches.length; i++) {
            for (int j = 0; j < stretches.length; j++) {
                covariance.multiplyEntry(i, j, stretches[i] * stretches[j]);
            }
        }
        Hypothesis hypothesis = fitted.fit().hypothesis();
        List<List<Double>> deviations = new ArrayList<>();
        int first = 0;
        for (int c = 0; c < hypothesis.causes().size(); c++) {
            double[] theta = hypothesis.theta().get(c);
            int last = first + theta.length - 1;
            RealMatrix part = covariance.getSubMatrix(first, last, first, last);
            deviations.add(ofQuantities(hypothesis.causes().get(c), theta, part, first));
            first = last + 1;
        }
        return deviations;
    }

    /** Those of a cause whose first number is the so many-th of all. */
    private List<Double> ofQuantities(
            Cause cause, double[] theta, RealMatrix covariance, int first) {
        RealMatrix slopes = slopes(cause, theta, latestBegin());
        RealMatrix ofQuantities = slopes.multiply(covariance).multiply(slopes.transpose());
        List<Quantity> quantities = cause.quantities(theta);
        List<Double> deviations = new ArrayList<>();
        for (int q = 0; q < quantities.size(); q++) {
            double variance = Math.max(0, ofQuantities.getEntry(q, q));
            double size = Math.abs(quantities.get(q).value());
            boolean isTold = true;
            for (int p = 0; p < theta.length; p++) {
                double change = slopes.getEntry(q, p) * cause.parameters().get(p).scale();
                isTold &= leavesATrace(first + p) || Math.abs(change) <= UNCHANGED * size;
            }
            deviations.add(isTold ? Math.sqrt(variance) : Double.NaN);
        }
        return deviations;
    }

    /** How far from the world's time 0 a run begins (s), at most. */
    private double latestBegin() {
        return fitted.fit().data().stream()
                .mapToDouble(data -> Math.abs(data.run().time(0)))
                .max()
                .orElse(0);
    }

    /**
     * How much each quantity changes with each number, over a small step to either side. A phase is
     * told at the world's time 0: it turns with the frequency by all the time since then.
     */
    private static RealMatrix slopes(Cause cause, double[] theta, double latestBegin) {
        RealMatrix slopes = new Array2DRowRealMatrix(cause.quantities(theta).size(), theta.length);
        for (int p = 0; p < theta.length; p++) {
            Parameter of = cause.parameters().get(p);
            double step = Cause.SMALL * of.scale();
            if (of.unit().equals("rad/s")) {
                step = Math.min(step, SLIGHT_TURN / latestBegin);
            }
            double low = of.isFree() ? of.clipped(theta[p] - step) : theta[p] - step;
            double high = of.isFree() ? of.clipped(theta[p] + step) : theta[p] + step;
            List<Quantity> below = moved(cause, theta, p, low);
            List<Quantity> above = moved(cause, theta, p, high);
            for (int q = 0; q < below.size(); q++) {
                slopes.setEntry(q, p, change(below.get(q), above.get(q)) / (high - low));
            }
        }
        return slopes;
    }

    private static List<Quantity> moved(Cause cause, double[] theta, int number, double to) {
        double[] moved = theta.clone();
        moved[number] = to;
        return cause.quantities(moved);
    }

    /** An angle that is told with some half turns more is the same: what swings, swings back. */
    private static double change(Quantity from, Quantity to) {
        double change = to.value() - from.value();
        return from.unit().equals("rad") ? StrictMath.IEEEremainder(change, Math.PI) : change;
    }
}
