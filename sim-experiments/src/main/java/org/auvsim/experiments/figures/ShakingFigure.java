package org.auvsim.experiments.figures;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;

/**
 * What a propeller that is out of balance leaves in two sensors, beside a sound one: the products
 * of their second differences, added up, as {@code propeller_imbalance} has them. The rotor turns
 * some fifty times a second; 20 rows a second show an alias of that.
 */
final class ShakingFigure {
    private static final int ROWS = 200;
    private static final double INTERVAL = 0.05;
    private static final double THRUST = 10;

    /** Turns a second at 1 N; the speed wanders by a share of it. */
    private static final double TURNS = 15;

    private static final double WANDERING = 0.2;

    /** Of both sensors (m/s^2, rad/s). */
    private static final double NOISE = 0.05;

    /** By how much the gyro's filter is behind the accelerometer's (rad). */
    private static final double BEHIND = 0.6;

    private ShakingFigure() {}

    static Figure drawn() {
        return new Figure(
                "propeller_imbalance",
                "propeller_imbalance: D2(a) D2(w) / 6, added up",
                "time (s)",
                "sum (m/s^2 rad/s)",
                List.of(sum("out of balance", 0.02), sum("sound", 0.01)));
    }

    /** With an imbalance (m/s^2 for each N of thrust). */
    private static Series sum(String name, double imbalance) {
        Random random = new Random(1);
        double[] acceleration = new double[ROWS];
        double[] rate = new double[ROWS];
        double angle = 0;
        for (int k = 0; k < ROWS; k++) {
            double turns = TURNS * Math.sqrt(THRUST) * (1 + WANDERING * random.nextGaussian());
            angle += 2 * Math.PI * turns * INTERVAL;
            double force = imbalance * THRUST;
            acceleration[k] = force * StrictMath.cos(angle) + NOISE * random.nextGaussian();
            rate[k] =
                    force / Math.sqrt(THRUST) * StrictMath.cos(angle - BEHIND)
                            + NOISE * random.nextGaussian();
        }
        List<Series.Point> points = new ArrayList<>();
        double sum = 0;
        for (int k = 1; k < ROWS - 1; k++) {
            sum += secondDifference(acceleration, k) * secondDifference(rate, k) / 6;
            points.add(new Series.Point(k * INTERVAL, sum));
        }
        return new Series(name, points);
    }

    private static double secondDifference(double[] of, int k) {
        return of[k - 1] - 2 * of[k] + of[k + 1];
    }
}
