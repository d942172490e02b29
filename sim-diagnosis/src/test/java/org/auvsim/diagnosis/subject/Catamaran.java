package org.auvsim.diagnosis.subject;

import org.auvsim.auvsml.AuvsmlException;
import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.diagnosis.model.BelievedModel;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.run.MeasuredRunBuilder;

import java.util.List;
import java.util.SplittableRandom;

/**
 * A catamaran whose two screws get other levels every 6 s, by equations of its own here, and whose
 * places are fixed so badly (3 m, now and then far more) that they hardly tell how it begins.
 */
public final class Catamaran {
    private static final double SURGE_MASS = 40;
    private static final double SWAY_MASS = 66;
    private static final double YAW_INERTIA = 13;
    private static final double SIDE = 0.35;
    private static final double THRUST = 30;

    private static final double INTERVAL = 0.1;
    private static final int SAMPLES = 380;
    private static final int STEADY = 60;
    private static final int PARTS = 50;

    private static final double PLACE = 3;
    private static final double HEADING = 0.1;

    private Catamaran() {}

    /** As it is. */
    public static BelievedModel believed() throws AuvsmlException {
        return Believed.model(
                """
                <scenario><time-step delta="0.05"/>
                  <world-object name="catamaran" mass="36">
                    <box><size x="1.2" y="0.8" z="0.3"/></box>
                    <inertia xx="4" yy="6" zz="8"/>
                    <added-mass><linear x="4" y="30" z="0"/><angular x="0" y="0" z="5"/></added-mass>
                    <held z="1" turn-x="1" turn-y="1"/>
                    <damping><linear x="12" y="40" z="0"/><quadratic x="8" y="60" z="0"/>
                      <angular-linear x="0" y="0" z="12"/><angular-quadratic x="0" y="0" z="6"/>
                    </damping>
                    <propulsor name="port" maximum-thrust="30">
                      <position x="-0.5" y="0.35" z="0"/>
                    </propulsor>
                    <propulsor name="starboard" maximum-thrust="30">
                      <position x="-0.5" y="-0.35" z="0"/>
                    </propulsor>
                  </world-object>
                </scenario>
                """,
                "catamaran");
    }

    /** Begun at rest, which no document says. */
    public static MeasuredRun run(long seed) {
        SplittableRandom lot = new SplittableRandom(seed);
        MeasuredRunBuilder run =
                MeasuredRun.named("run " + seed).commands(List.of("port", "starboard"));
        double[] state = {0, 0, 2 * lot.nextDouble() - 1, 0, 0, 0};
        double port = 0;
        double starboard = 0;
        for (int k = 0; k < SAMPLES; k++) {
            if (k % STEADY == 0) {
                port = -0.4 + 1.4 * lot.nextDouble();
                starboard = -0.4 + 1.4 * lot.nextDouble();
            }
            double x = state[0] + PLACE * heavyTailed(lot);
            double y = state[1] + PLACE * heavyTailed(lot);
            double heading = state[2] + HEADING * heavyTailed(lot);
            run.at(k * INTERVAL)
                    .position(x, y, 0)
                    .orientation(Quat.ofAxisAngle(new Vec3(0, 0, 1), heading))
                    .command(0, port)
                    .command(1, starboard);
            for (int j = 0; j < PARTS; j++) {
                move(state, port, starboard);
            }
        }
        return run.build();
    }

    /** Student's t of three degrees of freedom, of variance 1. */
    private static double heavyTailed(SplittableRandom lot) {
        double a = lot.nextGaussian();
        double b = lot.nextGaussian();
        double c = lot.nextGaussian();
        return lot.nextGaussian() / Math.sqrt(a * a + b * b + c * c);
    }

    /** By the midpoint rule. */
    private static void move(double[] state, double port, double starboard) {
        double h = INTERVAL / PARTS;
        double[] half = state.clone();
        add(half, rates(state, port, starboard), h / 2);
        add(state, rates(half, port, starboard), h);
    }

    private static void add(double[] state, double[] rates, double time) {
        for (int i = 0; i < state.length; i++) {
            state[i] += time * rates[i];
        }
    }

    /** Of x, y, heading, surge, sway and yaw. */
    private static double[] rates(double[] of, double port, double starboard) {
        double cos = Math.cos(of[2]);
        double sin = Math.sin(of[2]);
        double u = of[3];
        double v = of[4];
        double r = of[5];
        double ahead = THRUST * (port + starboard) - 12 * u - 8 * Math.abs(u) * u;
        double aside = -40 * v - 60 * Math.abs(v) * v;
        double turning = THRUST * SIDE * (starboard - port) - 12 * r - 6 * Math.abs(r) * r;
        return new double[] {
            cos * u - sin * v,
            sin * u + cos * v,
            r,
            (ahead + SWAY_MASS * v * r) / SURGE_MASS,
            (aside - SURGE_MASS * u * r) / SWAY_MASS,
            (turning - (SWAY_MASS - SURGE_MASS) * u * v) / YAW_INERTIA
        };
    }
}
