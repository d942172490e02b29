package org.auvsim.diagnosis;

import org.auvsim.auvsml.AuvsmlException;
import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.diagnosis.model.BelievedModel;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.run.MeasuredRunBuilder;
import org.auvsim.diagnosis.subject.Believed;

import java.util.List;
import java.util.SplittableRandom;
import java.util.function.DoubleUnaryOperator;

/**
 * A vehicle with two thrusters side by side that moves in the horizontal plane, by equations of its
 * own here.
 *
 * @param port thrust of the one to the left
 * @param starboard likewise
 * @param compass the heading (rad) that is measured, of the true one
 * @param samples of a run, ten a second
 * @param placeNoise standard deviation of positions (m)
 * @param turnNoise that of headings (rad)
 */
public record TwinScrew(
        Screw port,
        Screw starboard,
        DoubleUnaryOperator compass,
        int samples,
        double placeNoise,
        double turnNoise) {
    /** N at full level. */
    static final double THRUST = 20;

    /** As it is believed, measured well for 12 s. */
    public static final TwinScrew SOUND =
            new TwinScrew(
                    (level, _, _) -> THRUST * level,
                    (level, _, _) -> THRUST * level,
                    heading -> heading,
                    120,
                    0.01,
                    0.01);

    /** Thrust (N) by level, and by time (s) and speed ahead (m/s), by which the model has none. */
    interface Screw {
        double thrust(double level, double time, double advance);
    }

    private static final double MASS = 12;
    private static final double INERTIA = 1.1;

    private static final double SIDE = 0.15;

    /** N s^2/m^2 ahead and aside, N m s/rad. */
    private static final double AHEAD = 9;

    private static final double ASIDE = 30;
    private static final double TURNING = 1.5;

    private static final double INTERVAL = 0.1;
    private static final int SUBSTEPS = 200;

    /** The same, its thrusters otherwise. */
    TwinScrew pushing(Screw left, Screw right) {
        return new TwinScrew(left, right, compass, samples, placeNoise, turnNoise);
    }

    /** The same, its heading measured otherwise. */
    public TwinScrew steering(DoubleUnaryOperator otherwise) {
        return new TwinScrew(port, starboard, otherwise, samples, placeNoise, turnNoise);
    }

    /** The same, measured so often, and so well. */
    public TwinScrew measured(int many, double place, double turn) {
        return new TwinScrew(port, starboard, compass, many, place, turn);
    }

    /** As it is believed: both give what they should at any speed. */
    public static BelievedModel model() throws AuvsmlException {
        return Believed.model(
                """
                <scenario><time-step delta="0.05"/>
                  <world-object name="vehicle" mass="12">
                    <box><size x="0.8" y="0.4" z="0.3"/></box>
                    <inertia xx="0.5" yy="0.9" zz="1.1"/>
                    <damping><quadratic x="9" y="30" z="30"/>
                      <angular-linear x="1.5" y="1.5" z="1.5"/></damping>
                    <propulsor name="port" maximum-thrust="20">
                      <position x="0" y="0.15" z="0"/>
                    </propulsor>
                    <propulsor name="starboard" maximum-thrust="20">
                      <position x="0" y="-0.15" z="0"/>
                    </propulsor>
                  </world-object>
                </scenario>
                """,
                "vehicle");
    }

    /** Thrusters get other levels ahead every 2 s, as drawn by a seed. */
    public MeasuredRun run(long seed) {
        return run(seed, 0.2, 0.6);
    }

    /** The same, of levels ahead and astern. */
    MeasuredRun runBothWays(long seed) {
        return run(seed, -0.6, 1.4);
    }

    private MeasuredRun run(long seed, double least, double span) {
        SplittableRandom lot = new SplittableRandom(seed);
        MeasuredRunBuilder run =
                MeasuredRun.named("run " + seed).commands(List.of("port", "starboard"));
        double[] state = new double[7]; // x, y, heading, ahead, aside, turning, time
        double left = 0;
        double right = 0;
        for (int k = 0; k < samples; k++) {
            if (k % 20 == 0) {
                left = least + span * lot.nextDouble();
                right = left + 0.2 * lot.nextDouble() - 0.1;
            }
            run.at(k * INTERVAL)
                    .position(
                            state[0] + placeNoise * lot.nextGaussian(),
                            state[1] + placeNoise * lot.nextGaussian(),
                            placeNoise * lot.nextGaussian())
                    .orientation(
                            Quat.ofAxisAngle(
                                    new Vec3(0, 0, 1),
                                    compass.applyAsDouble(state[2])
                                            + turnNoise * lot.nextGaussian()))
                    .command(0, left)
                    .command(1, right);
            for (int j = 0; j < SUBSTEPS; j++) {
                move(state, left, right);
            }
        }
        return run.build();
    }

    /** By the midpoint rule. */
    private void move(double[] state, double left, double right) {
        double h = INTERVAL / SUBSTEPS;
        double[] half = state.clone();
        add(half, rates(state, left, right), h / 2);
        add(state, rates(half, left, right), h);
    }

    private static void add(double[] state, double[] rates, double time) {
        for (int i = 0; i < state.length; i++) {
            state[i] += time * rates[i];
        }
    }

    private double[] rates(double[] s, double left, double right) {
        double cos = Math.cos(s[2]);
        double sin = Math.sin(s[2]);
        double ahead = s[3];
        double aside = s[4];
        double turning = s[5];
        double pushLeft = port.thrust(left, s[6], ahead - SIDE * turning);
        double pushRight = starboard.thrust(right, s[6], ahead + SIDE * turning);
        return new double[] {
            cos * ahead - sin * aside,
            sin * ahead + cos * aside,
            turning,
            (pushLeft + pushRight - AHEAD * Math.abs(ahead) * ahead) / MASS + turning * aside,
            -ASIDE * Math.abs(aside) * aside / MASS - turning * ahead,
            (SIDE * (pushRight - pushLeft) - TURNING * turning) / INERTIA,
            1
        };
    }
}
