package org.auvsim.diagnosis.cause;

import org.auvsim.auvsml.AuvsmlException;
import org.auvsim.auvsml.document.ScenarioLoader;
import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.diagnosis.model.BelievedModel;
import org.auvsim.diagnosis.model.Ensemble;
import org.auvsim.diagnosis.model.Variant;
import org.auvsim.diagnosis.run.Channel;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.run.MeasuredRunBuilder;
import org.auvsim.server.feedback.RigidMotion;

import java.nio.charset.StandardCharsets;
import java.util.List;

/** Models for tests of causes, and runs of their bodies. */
final class Tank {
    static final double SPACING = 0.05;
    static final RigidMotion START =
            new RigidMotion(
                    new Vec3(0.4, -0.3, 0.2),
                    new Quat(0.96, 0.1, -0.15, 0.2).normalized(),
                    new Vec3(0.9, -0.5, 0.3),
                    new Vec3(0.3, -0.4, 0.5));

    private Tank() {}

    /** A body of which nothing is known but mass and inertia. */
    static BelievedModel bare() {
        return model("", "");
    }

    /** A vehicle in water, with a fixed wall beside it. */
    static BelievedModel vehicle() {
        return model(
                """
                <world-object name="wall" fixed="1">
                  <half-space/>
                  <position x="0" y="0" z="-50"/>
                </world-object>
                """,
                """
                <added-mass><linear x="4" y="6" z="8"/></added-mass>
                <gravity/>
                <buoyancy volume="0.012" density="1000" surface="100"/>
                <damping><linear x="3" y="5" z="6"/><quadratic x="4" y="9" z="9"/>
                    <angular-linear x="0.5" y="0.6" z="0.7"/></damping>
                <propulsor name="port" maximum-thrust="20" level="0.6">
                  <position x="-0.4" y="0.15" z="0"/>
                </propulsor>
                <propulsor name="starboard" maximum-thrust="20" level="0.4">
                  <position x="-0.4" y="-0.15" z="0"/>
                </propulsor>
                """);
    }

    /** A slender vehicle with a rudder and a plane. */
    static BelievedModel steered() {
        return model(
                "",
                """
                <damping><quadratic x="4" y="9" z="9"/></damping>
                <propulsor name="port" maximum-thrust="20" level="0.6"/>
                <fin name="rudder" area="0.01" lift-slope="3">
                  <position x="-0.4" y="0" z="0"/><span x="0" y="0" z="1"/>
                </fin>
                <fin name="plane" area="0.01" lift-slope="3">
                  <position x="-0.4" y="0" z="0"/><span x="0" y="1" z="0"/>
                </fin>
                """);
    }

    /** A body that turns about one axis. */
    static BelievedModel pendulum() {
        return model(
                "",
                """
                <centre-of-mass x="0" y="0" z="-0.5"/>
                <pinned><axis x="0" y="1" z="0"/></pinned>
                <gravity/>
                """);
    }

    static BelievedModel model(String world, String body) {
        try {
            String xml =
                    """
                    <scenario>
                      <time-step delta="0.05"/>
                      %s
                      <world-object name="vehicle" mass="12">
                        <box><size x="0.8" y="0.4" z="0.3"/></box>
                        <inertia xx="0.5" yy="0.9" zz="1.1"/>
                        %s
                      </world-object>
                    </scenario>
                    """
                            .formatted(world, body);
            return new BelievedModel(
                    ScenarioLoader.load(Tank.class.getClassLoader())
                            .parse(xml.getBytes(StandardCharsets.UTF_8)),
                    "vehicle");
        } catch (AuvsmlException e) {
            throw new IllegalArgumentException(e.getMessage(), e);
        }
    }

    /** Times without measurements. */
    static MeasuredRun times(int samples) {
        MeasuredRunBuilder run = MeasuredRun.named("times");
        for (int k = 0; k < samples; k++) {
            run.at(k * SPACING);
        }
        return run.build();
    }

    /** How a variant moves. */
    static RigidMotion[] motion(BelievedModel model, Variant variant, int samples) {
        return Ensemble.simulate(
                model,
                times(samples),
                0,
                samples - 1,
                List.of(new Ensemble.Entrant(variant, START)))[0];
    }

    /** What the model does, as if it had been measured. */
    static MeasuredRun run(BelievedModel model, int samples) {
        RigidMotion[] motions = motion(model, model.variant(), samples);
        MeasuredRunBuilder run = MeasuredRun.named("run");
        for (int k = 0; k < samples; k++) {
            RigidMotion m = motions[k];
            run.at(k * SPACING)
                    .position(m.position().x(), m.position().y(), m.position().z())
                    .orientation(m.orientation())
                    .measured(
                            Channel.VELOCITY, m.velocity().x(), m.velocity().y(), m.velocity().z());
        }
        return run.build();
    }
}
