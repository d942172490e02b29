package org.auvsim.diagnosis.subject;

import org.auvsim.auvsml.AuvsmlException;
import org.auvsim.core.entity.Frame;
import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.diagnosis.model.BelievedModel;
import org.auvsim.diagnosis.run.Channel;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.run.MeasuredRunBuilder;

import java.util.List;
import java.util.Random;
import java.util.function.IntFunction;

/**
 * A vehicle with two thrusters ahead and one upward, by equations of its own, of which the model
 * knows the linear drag and damping alone.
 *
 * @param quadratic what its drag has beside (kg/m)
 * @param current in which it moves (m/s)
 * @param port share of its thrust that the port thruster has
 * @param turning what its damping about the vertical has beside (N m s/rad)
 */
public record Surveyor(double quadratic, Vec3 current, double port, double turning) {
    private static final double MASS = 30;
    private static final double INERTIA = MASS / 12 * (0.8 * 0.8 + 0.5 * 0.5);
    private static final double LINEAR = 8;
    private static final double DAMPING = 2;
    private static final double THRUST = 20;
    private static final double LIFT = 15;
    private static final double ARM = 0.25;

    private static final double NOISE = 0.01;
    private static final double NOISE_OF_YAW = 0.005;
    private static final double STEP = 0.01;
    private static final int STEPS_A_ROW = 10;
    private static final int ROWS = 201;

    /** Levels change every so many rows. */
    private static final int HELD = 50;

    private static final Vec3 UP = new Vec3(0, 0, 1);

    /** Without what it lacks. */
    public static BelievedModel believed() throws AuvsmlException {
        return Believed.model(
                """
                <scenario><time-step delta="0.05"/>
                  <world-object name="Surveyor" mass="30"><box><size x="0.8" y="0.5" z="0.3"/></box>
                    <damping><linear x="8" y="8" z="8"/><angular-linear x="2" y="2" z="2"/></damping>
                    <propulsor name="port" maximum-thrust="20">
                      <position x="-0.4" y="0.25" z="0"/></propulsor>
                    <propulsor name="starboard" maximum-thrust="20">
                      <position x="-0.4" y="-0.25" z="0"/></propulsor>
                    <propulsor name="vertical" maximum-thrust="15">
                      <direction x="0" y="0" z="1"/></propulsor>
                  </world-object></scenario>
                """,
                "Surveyor");
    }

    /** A run of 20 s from rest, ten rows a second, under commands drawn by lot. */
    public MeasuredRun run(String name, Random random) {
        return run(name, random, false);
    }

    /** The same, of which the rate of yaw is measured, too. */
    public MeasuredRun runWithRate(String name, Random random) {
        return run(name, random, true);
    }

    private MeasuredRun run(String name, Random random, boolean isRateMeasured) {
        MeasuredRunBuilder run =
                MeasuredRun.named(name)
                        .commands(List.of("port", "starboard", "vertical"))
                        .frame(Channel.ANGULAR_VELOCITY, Frame.BODY);
        double[] state = {0, 0, -5, random.nextDouble(-1, 1), 0, 0, 0, 0};
        double[] levels = new double[3];
        for (int k = 0; k < ROWS; k++) {
            if (k % HELD == 0) {
                levels = random.doubles(levels.length, -0.6, 1).toArray();
            }
            run.at(k * STEP * STEPS_A_ROW)
                    .position(
                            state[0] + NOISE * random.nextGaussian(),
                            state[1] + NOISE * random.nextGaussian(),
                            state[2] + NOISE * random.nextGaussian())
                    .orientation(
                            Quat.ofAxisAngle(UP, state[3] + NOISE_OF_YAW * random.nextGaussian()),
                            false,
                            false,
                            true);
            if (isRateMeasured) {
                double rate = state[7] + NOISE_OF_YAW * random.nextGaussian();
                run.measured(Channel.ANGULAR_VELOCITY, Double.NaN, Double.NaN, rate);
            }
            for (int i = 0; i < levels.length; i++) {
                run.command(i, levels[i]);
            }
            for (int s = 0; s < STEPS_A_ROW; s++) {
                state = step(state, levels);
            }
        }
        return run.build();
    }

    /** The same run, its sensors telling other places (m, world) and headings at its samples. */
    public static MeasuredRun told(
            MeasuredRun of, IntFunction<Vec3> place, IntFunction<Quat> heading) {
        MeasuredRunBuilder told =
                MeasuredRun.named(of.name()).commands(List.of("port", "starboard", "vertical"));
        for (int k = 0; k < of.size(); k++) {
            Vec3 p = place.apply(k);
            told.at(of.time(k))
                    .position(p.x(), p.y(), p.z())
                    .orientation(heading.apply(k), false, false, true);
            for (int c = 0; c < of.commands().size(); c++) {
                told.command(c, of.commands().get(c).level(k));
            }
        }
        return told.build();
    }

    /** Of place, yaw, velocity and rate of yaw. */
    private double[] rates(double[] s, double[] levels) {
        Vec3 through = new Vec3(s[4], s[5], s[6]).minus(current);
        double drag = LINEAR + quadratic * through.norm();
        double ofPort = THRUST * port * levels[0];
        double ofStarboard = THRUST * levels[1];
        double ahead = ofPort + ofStarboard;
        return new double[] {
            s[4],
            s[5],
            s[6],
            s[7],
            (ahead * Math.cos(s[3]) - drag * through.x()) / MASS,
            (ahead * Math.sin(s[3]) - drag * through.y()) / MASS,
            (LIFT * levels[2] - drag * through.z()) / MASS,
            (ARM * (ofStarboard - ofPort) - (DAMPING + turning) * s[7]) / INERTIA
        };
    }

    /** Runge-Kutta of fourth order. */
    private double[] step(double[] state, double[] levels) {
        double[] k1 = rates(state, levels);
        double[] k2 = rates(along(state, k1, STEP / 2), levels);
        double[] k3 = rates(along(state, k2, STEP / 2), levels);
        double[] k4 = rates(along(state, k3, STEP), levels);
        double[] next = state.clone();
        for (int i = 0; i < next.length; i++) {
            next[i] += STEP / 6 * (k1[i] + 2 * k2[i] + 2 * k3[i] + k4[i]);
        }
        return next;
    }

    private static double[] along(double[] state, double[] rates, double span) {
        double[] there = state.clone();
        for (int i = 0; i < there.length; i++) {
            there[i] += span * rates[i];
        }
        return there;
    }
}
