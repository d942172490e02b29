package org.auvsim.experiments.hidden;

import org.apache.commons.math3.geometry.euclidean.threed.Vector3D;
import org.apache.commons.math3.linear.Array2DRowRealMatrix;
import org.apache.commons.math3.linear.ArrayRealVector;
import org.apache.commons.math3.linear.RealMatrix;
import org.apache.commons.math3.linear.RealVector;
import org.apache.commons.math3.linear.SingularValueDecomposition;
import org.apache.commons.math3.util.FastMath;
import org.auvsim.core.math.Vec3;
import org.auvsim.diagnosis.run.Command;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.run.ScheduledForce;
import org.auvsim.experiments.hidden.Derivatives.Smoothed;
import org.auvsim.experiments.hidden.Manoeuvre.TimedPush;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;

/**
 * The plain way, to compare with: accelerations by smoothing, what the believed model lacks of them
 * as a sum of few terms of a library by sequentially thresholded least squares (Brunton, Proctor
 * and Kutz, PNAS 113, 2016), the threshold by the information criterion of Schwarz.
 */
public final class SparseRegression {
    private static final int ROUNDS = 10;
    private static final double[] THRESHOLDS = {0.02, 0.05, 0.1, 0.2, 0.4, 0.8, 2};

    private final Scene scene;
    private final List<Term> terms;
    private final List<double[]> rows = new ArrayList<>();
    private final List<Double> lacking = new ArrayList<>();

    private SparseRegression(Scene scene) {
        this.scene = scene;
        this.terms = Term.all(scene);
    }

    /** Names of the causes that it selects for a case. */
    public static List<String> causes(HiddenCase of) {
        SparseRegression regression = new SparseRegression(of.scene());
        of.fit().forEach(regression::add);
        return regression.selected();
    }

    private void add(MeasuredRun run) {
        List<double[]> changes = new ArrayList<>();
        List<Smoothed> smoothed = Derivatives.of(run);
        double[][] believed = accelerations(Reality.of(scene.plant()), run, smoothed);
        for (Term term : terms) {
            double[][] changed =
                    accelerations(term.change().apply(Reality.of(scene.plant())), run, smoothed);
            changes.add(flat(changed, believed));
        }
        double[] measured = measured(smoothed);
        double[] model = flat(believed, new double[believed.length][6]);
        for (int i = 0; i < measured.length; i++) {
            boolean turns = i % 6 >= 3;
            if (turns && !scene.shows()) {
                continue;
            }
            // Accelerations in units of what there is of them, so that both kinds count alike.
            double unit = turns ? scene.turns() : scene.range();
            int row = i;
            rows.add(changes.stream().mapToDouble(c -> c[row] / unit).toArray());
            lacking.add((measured[i] - model[i]) / unit);
        }
    }

    private static double[] measured(List<Smoothed> smoothed) {
        double[] all = new double[6 * smoothed.size()];
        for (int i = 0; i < smoothed.size(); i++) {
            Instant.put(smoothed.get(i).acceleration(), all, 6 * i);
            Instant.put(smoothed.get(i).turning(), all, 6 * i + 3);
        }
        return all;
    }

    private static double[] flat(double[][] of, double[][] less) {
        double[] all = new double[6 * of.length];
        for (int i = 0; i < all.length; i++) {
            all[i] = of[i / 6][i % 6] - less[i / 6][i % 6];
        }
        return all;
    }

    private static double[][] accelerations(
            Reality reality, MeasuredRun run, List<Smoothed> smoothed) {
        Equations equations = new Equations(reality, List.of(), new int[0]);
        double[][] all = new double[smoothed.size()][];
        for (int i = 0; i < all.length; i++) {
            int k = smoothed.get(i).sample();
            double time = run.time(k);
            equations.hold(
                    time,
                    levels(
                            reality.plant().thrusters().stream().map(Thruster::name).toList(),
                            run,
                            k),
                    levels(reality.plant().foils().stream().map(Foil::name).toList(), run, k),
                    run.forces().stream()
                            .filter(f -> f.from() <= time && time < f.until())
                            .map(SparseRegression::push)
                            .toList());
            double[] y = new double[equations.getDimension()];
            smoothed.get(i).motion().putInto(y);
            double[] slope = new double[y.length];
            equations.computeDerivatives(time, y, slope);
            all[i] = Arrays.copyOfRange(slope, 7, Instant.SIZE);
        }
        return all;
    }

    private static double[] levels(List<String> names, MeasuredRun run, int sample) {
        double[] levels = new double[names.size()];
        for (Command command : run.commands()) {
            int i = names.indexOf(command.name());
            if (i >= 0) {
                levels[i] = command.level(sample);
            }
        }
        return levels;
    }

    private static TimedPush push(ScheduledForce f) {
        return new TimedPush(
                f.from(), f.until(), vector(f.force().vector()), vector(f.force().point()));
    }

    private static Vector3D vector(Vec3 v) {
        return new Vector3D(v.x(), v.y(), v.z());
    }

    private List<String> selected() {
        double best = information(List.of());
        List<Integer> chosen = List.of();
        for (double threshold : THRESHOLDS) {
            List<Integer> active = thresholded(threshold);
            double information = information(active);
            if (information < best) {
                best = information;
                chosen = active;
            }
        }
        return chosen.stream().map(i -> terms.get(i).cause()).distinct().toList();
    }

    /** Columns whose share of what is lacking is above a threshold, refitted until it stays so. */
    private List<Integer> thresholded(double threshold) {
        double size = new ArrayRealVector(lacking.toArray(Double[]::new)).getNorm();
        List<Integer> active =
                IntStream.range(0, terms.size()).filter(i -> norm(i) > 0).boxed().toList();
        for (int round = 0; round < ROUNDS && !active.isEmpty(); round++) {
            RealVector by = solved(active);
            List<Integer> now = active;
            active =
                    IntStream.range(0, now.size())
                            .filter(
                                    i ->
                                            FastMath.abs(by.getEntry(i)) * norm(now.get(i))
                                                    > threshold * size)
                            .mapToObj(now::get)
                            .toList();
            if (active.size() == now.size()) {
                break;
            }
        }
        return active;
    }

    private double norm(int column) {
        return FastMath.sqrt(rows.stream().mapToDouble(r -> r[column] * r[column]).sum());
    }

    private RealMatrix matrix(List<Integer> columns) {
        RealMatrix matrix = new Array2DRowRealMatrix(rows.size(), columns.size());
        for (int i = 0; i < rows.size(); i++) {
            for (int j = 0; j < columns.size(); j++) {
                matrix.setEntry(i, j, rows.get(i)[columns.get(j)]);
            }
        }
        return matrix;
    }

    private RealVector solved(List<Integer> columns) {
        return new SingularValueDecomposition(matrix(columns))
                .getSolver()
                .solve(new ArrayRealVector(lacking.toArray(Double[]::new)));
    }

    /** Schwarz: the smaller, the better. */
    private double information(List<Integer> columns) {
        RealVector left = new ArrayRealVector(lacking.toArray(Double[]::new));
        if (!columns.isEmpty()) {
            left = left.subtract(matrix(columns).operate(solved(columns)));
        }
        int n = rows.size();
        double squares = left.dotProduct(left);
        return n * FastMath.log(squares / n) + columns.size() * FastMath.log(n);
    }
}
