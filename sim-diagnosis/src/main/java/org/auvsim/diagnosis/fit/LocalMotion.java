package org.auvsim.diagnosis.fit;

import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.diagnosis.run.Channel;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.server.feedback.RigidMotion;

import org.apache.commons.math3.fitting.PolynomialCurveFitter;
import org.apache.commons.math3.fitting.WeightedObservedPoints;

import java.util.Optional;

/** The motion at a sample by what was measured around it, without any model: local parabolas. */
final class LocalMotion {
    private static final int DEGREE = 2;

    private LocalMotion() {}

    /** The motion at sample {@code at} by the samples from {@code from} up to {@code to}. */
    static RigidMotion at(MeasuredRun run, int at, int from, int to) {
        Quat axes = orientationNear(run, at);
        double[][] position = new double[3][];
        double[][] turn = new double[3][];
        for (int i = 0; i < 3; i++) {
            WeightedObservedPoints places = new WeightedObservedPoints();
            WeightedObservedPoints turns = new WeightedObservedPoints();
            for (int k = from; k <= to; k++) {
                double t = run.time(k) - run.time(at);
                double place = run.value(Channel.POSITION, k, i);
                if (!Double.isNaN(place)) {
                    places.add(t, place);
                }
                Optional<Quat> orientation = run.orientation(k);
                if (orientation.isPresent()) {
                    turns.add(t, Misses.axis(Misses.turn(axes, orientation.get()), i));
                }
            }
            position[i] = parabola(places);
            turn[i] = parabola(turns);
        }
        RigidMotion still = new RigidMotion(Vec3.ZERO, axes, Vec3.ZERO, Vec3.ZERO);
        return still.plus(
                new double[] {
                    position[0][0], position[1][0], position[2][0],
                    turn[0][0], turn[1][0], turn[2][0],
                    position[0][1], position[1][1], position[2][1],
                    turn[0][1], turn[1][1], turn[2][1]
                });
    }

    private static Quat orientationNear(MeasuredRun run, int at) {
        return run.orientation(at).orElse(Quat.IDENTITY);
    }

    private static double[] parabola(WeightedObservedPoints points) {
        int count = points.toList().size();
        if (count == 0) {
            return new double[DEGREE + 1];
        }
        double[] fitted =
                PolynomialCurveFitter.create(Math.min(DEGREE, count - 1)).fit(points.toList());
        double[] all = new double[DEGREE + 1];
        System.arraycopy(fitted, 0, all, 0, fitted.length);
        return all;
    }
}
