package org.auvsim.diagnosis.reading;

import org.apache.commons.math3.linear.SingularMatrixException;
import org.apache.commons.math3.stat.StatUtils;
import org.apache.commons.math3.stat.regression.OLSMultipleLinearRegression;
import org.auvsim.core.entity.Frame;
import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.diagnosis.run.Channel;
import org.auvsim.diagnosis.run.MeasuredRun;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;

/**
 * Measured velocities beside the way that a body goes, which should be their integral. What each
 * velocity has to be multiplied with for that is found by least squares; the factor of a usual
 * unit, or -1, is no accident.
 */
final class VelocityFactors {
    /** Fixes a velocity. */
    private static final int FEWEST = 8;

    /** A factor is that of a unit if it is as near, and is known as well (three deviations). */
    private static final double NEARLY = 0.05;

    private static final double NEARLY_OPPOSITE = 0.2;

    private static final int DEVIATIONS = 3;

    /** What a velocity contributes to ways is so many times what is left of them at least. */
    private static final double CLEAR = 5;

    private final MeasuredRun run;

    /** How many of them tell something, in the world and of the frame of the velocities. */
    private final int axes;

    private final List<Integer> told;

    /** Of each fix along each axis of the world: the integrals of the velocities, and the way. */
    private final List<double[]> integrals = new ArrayList<>();

    private final List<Double> lengths = new ArrayList<>();

    VelocityFactors(MeasuredRun run) {
        this.run = run;
        this.axes = mayTilt(run) ? 2 : 3;
        this.told =
                IntStream.range(0, axes)
                        .filter(axis -> run.measures(Channel.VELOCITY, axis))
                        .boxed()
                        .toList();
    }

    /** Whether a body may tilt by what nothing measured, so that its axis upwards may not be. */
    private static boolean mayTilt(MeasuredRun run) {
        return run.frame(Channel.VELOCITY) == Frame.BODY
                && !(run.measures(Channel.ORIENTATION, 0) && run.measures(Channel.ORIENTATION, 1));
    }

    /** What velocities may be told in. */
    private enum Unit {
        KILOMETRES_PER_HOUR("km/h", 3.6),
        KNOTS("knots", 3600 / 1852.0),
        MILES_PER_HOUR("mph", 3600 / 1609.344),
        FEET_PER_SECOND("feet per second", 1 / 0.3048),
        CENTIMETRES_PER_SECOND("cm/s", 100);

        private final String words;
        private final double times;

        Unit(String words, double times) {
            this.words = words;
            this.times = times;
        }

        boolean isOf(double factor) {
            return Math.abs(factor * times - 1) < NEARLY;
        }
    }

    /**
     * That a velocity is told in another unit, or the other way.
     *
     * @param axis 0 to 2, of the frame in which velocities are told
     */
    record Suspicion(int axis, String what) {}

    /** What is suspected, by axis. */
    List<Suspicion> suspicions() {
        collect();
        List<Suspicion> all = new ArrayList<>();
        if (told.isEmpty() || lengths.size() < FEWEST * told.size()) {
            return all;
        }
        double[][] x = new double[lengths.size()][];
        Arrays.setAll(x, i -> told.stream().mapToDouble(axis -> integrals.get(i)[axis]).toArray());
        OLSMultipleLinearRegression regression = new OLSMultipleLinearRegression();
        regression.setNoIntercept(true);
        regression.newSampleData(lengths.stream().mapToDouble(y -> y).toArray(), x);
        try {
            double[] factors = regression.estimateRegressionParameters();
            double[] deviations = regression.estimateRegressionParametersStandardErrors();
            double left = Math.sqrt(regression.estimateErrorVariance());
            for (int i = 0; i < factors.length; i++) {
                int axis = told.get(i);
                double[] ways = integrals.stream().mapToDouble(of -> of[axis]).toArray();
                double contributed = Math.abs(factors[i]) * Math.sqrt(StatUtils.variance(ways));
                if (contributed > CLEAR * left) {
                    what(factors[i], DEVIATIONS * deviations[i])
                            .ifPresent(what -> all.add(new Suspicion(axis, what)));
                }
            }
        } catch (SingularMatrixException e) {
            return List.of(); // it goes one way only, or nowhere, and nothing tells them apart
        }
        return all;
    }

    private static Optional<String> what(double factor, double uncertainty) {
        for (Unit unit : Unit.values()) {
            if (unit.isOf(factor) && uncertainty < NEARLY * factor) {
                return Optional.of(
                        "velocities are about %s times what positions say: are they in %s? If so, map them with a scale of %s (--mapping)"
                                .formatted(
                                        Figures.shown(unit.times, 3),
                                        unit.words,
                                        Figures.shown(1 / unit.times, 6)));
            }
        }
        boolean isOpposite =
                Math.abs(factor + 1) < NEARLY_OPPOSITE && uncertainty < NEARLY_OPPOSITE;
        return isOpposite
                ? Optional.of(
                        "velocities are the opposite of what positions say: are they positive the"
                                + " other way? If so, map them with a scale of -1 (--mapping)")
                : Optional.empty();
    }

    private void collect() {
        Gone[] gone = {new Gone(), new Gone(), new Gone()};
        Optional<Quat> turned = Optional.empty();
        List<List<double[]>> rows =
                List.of(new ArrayList<>(), new ArrayList<>(), new ArrayList<>());
        for (int k = 0; k < run.size(); k++) {
            double time = run.time(k);
            turned = run.orientation(k).isPresent() ? run.orientation(k) : turned;
            for (int axis : told) {
                velocity(k, axis, turned).ifPresent(now -> gone[axis].with(now, time));
            }
            for (int along = 0; along < axes; along++) {
                double place = run.value(Channel.POSITION, k, along);
                if (!Double.isNaN(place)) {
                    rows.get(along).add(row(gone, time, along, place));
                }
            }
        }
        rows.forEach(this::add);
    }

    /** The integral of a velocity that is told now and then. */
    private static final class Gone {
        private Vec3 way = Vec3.ZERO;
        private Vec3 velocity = Vec3.ZERO;
        private double since = Double.NaN;

        void with(Vec3 now, double time) {
            if (!Double.isNaN(since)) {
                way = way.plus(velocity.plus(now).times((time - since) / 2));
            }
            velocity = now;
            since = time;
        }

        Vec3 at(double time) {
            return Double.isNaN(since) ? way : way.plus(velocity.times(time - since));
        }
    }

    private static double[] row(Gone[] gone, double time, int along, double place) {
        return new double[] {
            gone[0].at(time).component(along),
            gone[1].at(time).component(along),
            gone[2].at(time).component(along),
            place
        };
    }

    /** Those of one axis of the world, without their means: where it began is not known. */
    private void add(List<double[]> rows) {
        double[] means = new double[4];
        for (double[] row : rows) {
            Arrays.setAll(means, i -> means[i] + row[i] / rows.size());
        }
        for (double[] row : rows) {
            Arrays.setAll(row, i -> row[i] - means[i]);
            integrals.add(row);
            lengths.add(row[3]);
        }
    }

    /** That along an axis of its frame, in the world's axes, if it is told there. */
    private Optional<Vec3> velocity(int k, int axis, Optional<Quat> turned) {
        double value = run.value(Channel.VELOCITY, k, axis);
        double[] one = new double[3];
        one[axis] = value;
        Vec3 told = new Vec3(one[0], one[1], one[2]);
        if (Double.isNaN(value)) {
            return Optional.empty();
        }
        return run.frame(Channel.VELOCITY) == Frame.WORLD
                ? Optional.of(told)
                : turned.map(q -> q.rotate(told));
    }
}
