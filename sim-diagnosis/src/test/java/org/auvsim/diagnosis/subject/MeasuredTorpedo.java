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

/**
 * A torpedo that begins at rest and is steered by a rudder for 40 s; its noisy place and its
 * heading are measured.
 */
public final class MeasuredTorpedo {
    private static final int SAMPLES = 401;
    private static final double SPACING = 0.1;
    private static final double NOISE = 0.5;
    private static final double TURN = 0.05;

    /** Areas (m^2) of its rudder, and of one that has lost a quarter. */
    public static final double RUDDER = 0.012;

    public static final double WORN = 0.75 * RUDDER;

    private MeasuredTorpedo() {}

    /** The model's own motion from rest in water that flows (m/s), with noise. */
    public static MeasuredRun run(BelievedModel model, int seed, double heading, Vec3 flow) {
        RigidMotion start =
                new RigidMotion(new Vec3(0, 0, -15), heading(heading), Vec3.ZERO, Vec3.ZERO);
        RigidMotion[] motion =
                Ensemble.simulate(
                        model,
                        measured(seed, new RigidMotion[0], Vec3.ZERO),
                        0,
                        SAMPLES - 1,
                        List.of(new Ensemble.Entrant(model.variant(), start)))[0];
        return measured(seed, motion, flow);
    }

    /** Commands, and what is measured of a motion, both drawn by a seed. */
    private static MeasuredRun measured(int seed, RigidMotion[] motion, Vec3 flow) {
        Random commands = new Random(seed);
        Random errors = new Random(seed + 100);
        MeasuredRunBuilder run =
                MeasuredRun.named("run" + seed).commands(List.of("screw", "rudder"));
        double screw = 0;
        double rudder = 0;
        for (int k = 0; k < SAMPLES; k++) {
            if (k % 40 == 0) {
                int side = k / 40 % 2 == 0 ? 1 : -1;
                screw = 0.5 + 0.4 * commands.nextDouble();
                rudder = side * (0.05 + 0.2 * commands.nextDouble());
            }
            run.at(k * SPACING).command(0, screw).command(1, rudder);
            if (motion.length > 0) {
                Vec3 p = motion[k].position().plus(flow.times(k * SPACING));
                Vec3 ahead = motion[k].orientation().rotate(new Vec3(1, 0, 0));
                double yaw = StrictMath.atan2(ahead.y(), ahead.x());
                run.position(
                                p.x() + NOISE * errors.nextGaussian(),
                                p.y() + NOISE * errors.nextGaussian(),
                                p.z() + NOISE * errors.nextGaussian())
                        .orientation(
                                heading(yaw + TURN * errors.nextGaussian()), false, false, true);
            }
        }
        return run.build();
    }

    private static Quat heading(double yaw) {
        return Quat.ofAxisAngle(new Vec3(0, 0, 1), yaw);
    }

    /** With a rudder of an area. */
    public static BelievedModel model(double rudder) throws DocumentException, AuvsmlException {
        return model(rudder, new Vec3(1, 0, 0));
    }

    /** The same, the rudder's chord along a direction (body). */
    public static BelievedModel model(double rudder, Vec3 chord)
            throws DocumentException, AuvsmlException {
        return new BelievedModel(
                ScenarioLoader.load(MeasuredTorpedo.class.getClassLoader())
                        .parse(
                                """
                                <scenario><time-step delta="0.05"/>
                                  <world-object name="Torpedo" mass="36">
                                    <capsule radius="0.09" length="1.5"/>
                                    <inertia xx="0.15" yy="6.2" zz="6.2"/>
                                    <added-mass><linear x="1.2" y="33" z="33"/>
                                      <angular x="0" y="5" z="5"/></added-mass>
                                    <position x="0" y="0" z="-15"/><gravity/>
                                    <buoyancy volume="0.035122" surface="100">
                                      <centre x="0" y="0" z="0.2"/></buoyancy>
                                    <damping><linear x="3" y="20" z="20"/>
                                      <quadratic x="6" y="130" z="130"/>
                                      <angular-linear x="0.6" y="9" z="9"/>
                                      <angular-quadratic x="0.2" y="25" z="25"/></damping>
                                    <propulsor name="screw" maximum-thrust="40">
                                      <position x="-0.8" y="0" z="0"/></propulsor>
                                    <fin name="rudder" area="%s" lift-slope="3.2"
                                        drag-coefficient="0.02" induced-drag="0.1">
                                      <position x="-0.75" y="0" z="0"/>
                                      <chord x="%s" y="%s" z="%s"/>
                                      <span x="0" y="0" z="1"/></fin>
                                  </world-object>
                                </scenario>
                                """
                                        .formatted(rudder, chord.x(), chord.y(), chord.z())
                                        .getBytes(UTF_8)),
                "Torpedo");
    }
}
