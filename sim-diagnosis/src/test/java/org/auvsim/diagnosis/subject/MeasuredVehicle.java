package org.auvsim.diagnosis.subject;

import static java.nio.charset.StandardCharsets.UTF_8;

import org.auvsim.auvsml.AuvsmlException;
import org.auvsim.auvsml.document.DocumentException;
import org.auvsim.auvsml.document.ScenarioLoader;
import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.diagnosis.model.BelievedModel;
import org.auvsim.diagnosis.model.Ensemble;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.run.MeasuredRunBuilder;
import org.auvsim.server.feedback.RigidMotion;

import java.util.List;
import java.util.Random;

/** An underwater vehicle with two thrusters, measured for 8 s. */
public final class MeasuredVehicle {
    private static final int SAMPLES = 161;
    private static final double SPACING = 0.05;
    private static final double NOISE = 0.01;

    private MeasuredVehicle() {}

    /** In time steps of a length (s). */
    public static BelievedModel model(double step) throws DocumentException, AuvsmlException {
        return new BelievedModel(
                ScenarioLoader.load(MeasuredVehicle.class.getClassLoader())
                        .parse(
                                """
                                <scenario><time-step delta="%s"/>
                                  <world-object name="vehicle" mass="12">
                                    <box><size x="0.8" y="0.4" z="0.3"/></box>
                                    <inertia xx="0.5" yy="0.9" zz="1.1"/>
                                    <added-mass><linear x="4" y="6" z="8"/></added-mass>
                                    <damping><linear x="3" y="5" z="6"/>
                                      <quadratic x="4" y="9" z="9"/>
                                      <angular-linear x="0.5" y="0.6" z="0.7"/></damping>
                                    <propulsor name="port" maximum-thrust="20">
                                      <position x="-0.4" y="0.15" z="0"/>
                                    </propulsor>
                                    <propulsor name="starboard" maximum-thrust="20">
                                      <position x="-0.4" y="-0.15" z="0"/>
                                    </propulsor>
                                  </world-object>
                                </scenario>
                                """
                                        .formatted(step)
                                        .getBytes(UTF_8)),
                "vehicle");
    }

    /** The model's own motion under commands that change, with noise. */
    public static MeasuredRun run(BelievedModel model) {
        return run(model, new Vec3(0.1, -0.2, 0.2));
    }

    /** The same from another angular velocity (rad/s). */
    public static MeasuredRun run(BelievedModel model, Vec3 angularVelocity) {
        return run(
                model,
                new RigidMotion(
                        new Vec3(0.4, -0.3, 0.2),
                        new Quat(0.96, 0.1, -0.15, 0.2).normalized(),
                        new Vec3(0.5, -0.2, 0.1),
                        angularVelocity));
    }

    /** The same from another start. */
    public static MeasuredRun run(BelievedModel model, RigidMotion start) {
        Random random = new Random(5);
        MeasuredRun commands = measured(random, new RigidMotion[0]);
        RigidMotion[] motion =
                Ensemble.simulate(
                        model,
                        commands,
                        0,
                        SAMPLES - 1,
                        List.of(new Ensemble.Entrant(model.variant(), start)))[0];
        return measured(random, motion);
    }

    private static MeasuredRun measured(Random random, RigidMotion[] motion) {
        MeasuredRunBuilder run = MeasuredRun.named("run").commands(List.of("port", "starboard"));
        for (int k = 0; k < SAMPLES; k++) {
            boolean isOutward = k / 40 % 2 == 0;
            run.at(k * SPACING).command(0, 0.6).command(1, isOutward ? 0.3 : 0.8);
            if (motion.length > 0) {
                Vec3 p = motion[k].position();
                run.position(p.x() + noise(random), p.y() + noise(random), p.z() + noise(random))
                        .orientation(motion[k].orientation());
            }
        }
        return run.build();
    }

    private static double noise(Random random) {
        return NOISE * random.nextGaussian();
    }
}
