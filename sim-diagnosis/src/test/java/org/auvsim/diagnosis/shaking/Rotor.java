package org.auvsim.diagnosis.shaking;

import static java.nio.charset.StandardCharsets.UTF_8;

import org.auvsim.auvsml.AuvsmlException;
import org.auvsim.auvsml.document.ScenarioLoader;
import org.auvsim.diagnosis.model.BelievedModel;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.run.MeasuredRunBuilder;

import java.util.List;
import java.util.Random;
import java.util.function.IntToDoubleFunction;

/**
 * What an accelerometer and a gyro tell of a rotor, by equations of its own: the force of what is
 * off its axis is as the square of its speed, the rate it leads to is as that over the speed. It
 * turns some hundred times a second, and wanders; of that 20 rows a second show an alias without
 * memory.
 *
 * @param imbalance its acceleration (m/s^2) at a thrust of 1 N
 * @param noise of both sensors
 */
record Rotor(double imbalance, double noise) {
    /** The thrust (N) is 40 times the square of the level. */
    static final double MOST = 40;

    private static final double LAG = 0.6;
    private static final double INTERVAL = 0.05;
    private static final double TURNS = 25;
    private static final double WANDERING = 0.2;

    static final BelievedModel MODEL = model();

    private static BelievedModel model() {
        String scenario =
                """
                <scenario>
                  <time-step delta="0.05"/>
                  <world-object name="Body" mass="3"><sphere radius="0.1"/>
                    <propulsor name="main" maximum-thrust="40" lag="0.1">
                      <polynomial-thrust coefficients="0 40"/>
                    </propulsor>
                  </world-object>
                </scenario>
                """;
        try {
            return new BelievedModel(
                    ScenarioLoader.load(Rotor.class.getClassLoader())
                            .parse(scenario.getBytes(UTF_8)),
                    "Body");
        } catch (AuvsmlException e) {
            throw new IllegalStateException(e);
        }
    }

    /** A run at one level. */
    MeasuredRun run(long seed, int rows, double level) {
        return run(seed, rows, k -> level, k -> 0, 1);
    }

    /**
     * A run.
     *
     * @param level by row
     * @param knock by row, on both sensors
     * @param sign of the gyro
     */
    MeasuredRun run(
            long seed, int rows, IntToDoubleFunction level, IntToDoubleFunction knock, int sign) {
        Random random = new Random(seed);
        MeasuredRunBuilder run = MeasuredRun.named("run " + seed).commands(List.of("main"));
        double angle = 2 * Math.PI * random.nextDouble();
        for (int k = 0; k < rows; k++) {
            double thrust = MOST * Math.pow(level.applyAsDouble(k), 2);
            double speed = TURNS * Math.sqrt(thrust) * (1 + WANDERING * random.nextGaussian());
            angle += 2 * Math.PI * speed * INTERVAL;
            double force = imbalance * thrust;
            double rate = imbalance * Math.sqrt(thrust);
            run.at(k * INTERVAL)
                    .position(k, 0, 0)
                    .command(0, level.applyAsDouble(k))
                    .shaking(
                            force * Math.cos(angle)
                                    + noise * random.nextGaussian()
                                    + knock.applyAsDouble(k),
                            sign * rate * Math.cos(angle - LAG)
                                    + noise * random.nextGaussian()
                                    + knock.applyAsDouble(k));
        }
        return run.build();
    }

    /** The covariance of both, for each thrust to the power 1.5. */
    double strength() {
        return imbalance * imbalance / 2 * Math.cos(LAG);
    }
}
