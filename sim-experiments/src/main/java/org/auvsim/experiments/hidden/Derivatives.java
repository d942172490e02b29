package org.auvsim.experiments.hidden;

import org.apache.commons.math3.geometry.euclidean.threed.Vector3D;
import org.apache.commons.math3.linear.Array2DRowRealMatrix;
import org.apache.commons.math3.linear.QRDecomposition;
import org.apache.commons.math3.linear.RealMatrix;
import org.apache.commons.math3.util.FastMath;
import org.auvsim.core.math.Quat;
import org.auvsim.diagnosis.run.Channel;
import org.auvsim.diagnosis.run.MeasuredRun;

import java.util.ArrayList;
import java.util.List;

/**
 * Motion and acceleration from measured poses by smoothing: polynomials fitted to a moving stretch
 * of samples (Savitzky and Golay, Analytical Chemistry 36, 1964).
 */
final class Derivatives {
    private static final int DEGREE = 3;
    private static final double STRETCH_SECONDS = 0.8;
    private static final int LEAST_REACH = 4;

    /** Stretches that a run has at least. */
    private static final double SHORTEST_RUN = 10;

    private final MeasuredRun run;
    private final int reach;
    private final RealMatrix solver;

    /** Motion at a sample, and how it changes (m/s^2, world; rad/s^2, body). */
    record Smoothed(int sample, Instant motion, Vector3D acceleration, Vector3D turning) {}

    private Derivatives(MeasuredRun run) {
        this.run = run;
        double step = run.duration() / (run.size() - 1);
        double stretch = Math.min(STRETCH_SECONDS, run.duration() / SHORTEST_RUN);
        reach = Math.max(LEAST_REACH, (int) Math.round(stretch / step / 2));
        RealMatrix powers = new Array2DRowRealMatrix(2 * reach + 1, DEGREE + 1);
        for (int i = -reach; i <= reach; i++) {
            for (int n = 0; n <= DEGREE; n++) {
                powers.setEntry(i + reach, n, FastMath.pow(i * step, n));
            }
        }
        solver = new QRDecomposition(powers).getSolver().getInverse();
    }

    /** Twice for each stretch, so that what is told of two neighbours is not quite the same. */
    static List<Smoothed> of(MeasuredRun run) {
        Derivatives derivatives = new Derivatives(run);
        List<Smoothed> all = new ArrayList<>();
        for (int k = derivatives.reach;
                k < run.size() - derivatives.reach;
                k += derivatives.reach) {
            all.add(derivatives.at(k));
        }
        return all;
    }

    private Smoothed at(int k) {
        Vector3D[] path = fitted(i -> position(k + i));
        boolean shows = run.measures(Channel.ORIENTATION);
        Attitude there = shows ? attitude(k) : Attitude.LEVEL;
        Vector3D[] turns =
                shows
                        ? fitted(i -> turn(there, attitude(k + i)))
                        : new Vector3D[] {Vector3D.ZERO, Vector3D.ZERO, Vector3D.ZERO};
        Instant motion = new Instant(run.time(k), path[0], there, path[1], turns[1], Vector3D.ZERO);
        return new Smoothed(k, motion, path[2], turns[2]);
    }

    @FunctionalInterface
    private interface Around {
        Vector3D at(int offset);
    }

    /** Value, first and second derivative at a sample. */
    private Vector3D[] fitted(Around values) {
        Vector3D[] terms = {Vector3D.ZERO, Vector3D.ZERO, Vector3D.ZERO};
        for (int i = -reach; i <= reach; i++) {
            Vector3D value = values.at(i);
            for (int n = 0; n < terms.length; n++) {
                double factor = n == 2 ? 2 : 1;
                terms[n] = terms[n].add(factor * solver.getEntry(n, i + reach), value);
            }
        }
        return terms;
    }

    private Vector3D position(int k) {
        return new Vector3D(
                run.value(Channel.POSITION, k, 0),
                run.value(Channel.POSITION, k, 1),
                run.value(Channel.POSITION, k, 2));
    }

    private Attitude attitude(int k) {
        Quat q = run.orientation(k).orElseThrow();
        return new Attitude(q.w(), q.x(), q.y(), q.z());
    }

    /** From one attitude to another, as a rotation vector in the first one's axes. */
    private static Vector3D turn(Attitude from, Attitude to) {
        Attitude d = new Attitude(from.w(), -from.x(), -from.y(), -from.z()).after(to);
        double sign = d.w() < 0 ? -1 : 1;
        Vector3D axis = new Vector3D(sign * d.x(), sign * d.y(), sign * d.z());
        double sine = axis.getNorm();
        double angle = 2 * FastMath.atan2(sine, sign * d.w());
        return sine < 1e-12 ? Vector3D.ZERO : axis.scalarMultiply(angle / sine);
    }
}
