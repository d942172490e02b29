package org.auvsim.experiments.figures;

import org.auvsim.auvsml.AuvsmlException;
import org.auvsim.auvsml.document.ScenarioLoader;
import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.diagnosis.cause.Cause;
import org.auvsim.diagnosis.cause.Library;
import org.auvsim.diagnosis.model.BelievedModel;
import org.auvsim.diagnosis.model.Ensemble;
import org.auvsim.diagnosis.model.Variant;
import org.auvsim.diagnosis.run.KnownStart;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.run.MeasuredRunBuilder;
import org.auvsim.server.feedback.RigidMotion;

import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.stream.IntStream;

/**
 * A body on which causes are shown: what is measured of it if its model lacks one.
 *
 * @param objects of the scenario, one of them {@code body}
 * @param seconds for how long it is measured
 */
record CauseStage(String objects, RigidMotion start, double seconds) {
    /** A vehicle in water with three thrusters that are told something else every few seconds. */
    static final CauseStage VEHICLE =
            new CauseStage(
                    """
                    <world-object name="body" mass="12">
                      <box><size x="0.8" y="0.4" z="0.3"/></box>
                      <inertia xx="0.5" yy="0.9" zz="1.1"/>
                      <added-mass><linear x="4" y="8" z="8"/></added-mass>
                      <gravity/>
                      <buoyancy volume="0.012" density="1000" surface="100">
                        <centre x="0" y="0" z="0.02"/>
                      </buoyancy>
                      <damping>
                        <linear x="4" y="6" z="6"/>
                        <quadratic x="12" y="25" z="25"/>
                        <angular-linear x="1" y="1" z="1"/>
                      </damping>
                      <propulsor name="port" maximum-thrust="20"><position x="-0.4" y="0.15" z="0"/></propulsor>
                      <propulsor name="starboard" maximum-thrust="20"><position x="-0.4" y="-0.15" z="0"/></propulsor>
                      <propulsor name="lift" maximum-thrust="20"><direction x="0" y="0" z="1"/></propulsor>
                    </world-object>
                    """,
                    new RigidMotion(
                            new Vec3(1, -2, -3), Quat.IDENTITY, new Vec3(0.4, 0.1, 0), Vec3.ZERO),
                    20);

    /** A torpedo whose rudder is told something else every four seconds. */
    static final CauseStage STEERED =
            new CauseStage(
                    """
                    <world-object name="body" mass="30">
                      <capsule radius="0.1" length="1.1"/>
                      <inertia xx="0.2" yy="3.5" zz="3.5"/>
                      <added-mass><linear x="1" y="30" z="30"/><angular x="0" y="4" z="4"/></added-mass>
                      <damping>
                        <quadratic x="2" y="130" z="130"/>
                        <angular-linear x="1" y="30" z="30"/>
                      </damping>
                      <propulsor name="screw" maximum-thrust="5" level="1"/>
                      <fin name="rudder" area="0.013" lift-slope="3" density="1000" maximum-angle="1">
                        <position x="-0.6" y="0" z="0"/><span x="0" y="0" z="1"/>
                      </fin>
                    </world-object>
                    """,
                    new RigidMotion(
                            new Vec3(0, 0, -3), Quat.IDENTITY, new Vec3(1.5, 0, 0), Vec3.ZERO),
                    20);

    /** A body that flies and spins, and that nothing holds back. */
    static final CauseStage SPINNER =
            new CauseStage(
                    """
                    <world-object name="body" mass="5">
                      <box><size x="0.5" y="0.3" z="0.2"/></box>
                      <inertia xx="0.05" yy="0.12" zz="0.14"/>
                    </world-object>
                    """,
                    new RigidMotion(
                            Vec3.ZERO,
                            Quat.IDENTITY,
                            new Vec3(0.5, 0.2, 0.1),
                            new Vec3(0.3, 0.2, 0.8)),
                    20);

    /** A bob that swings about one axis. */
    static final CauseStage PENDULUM =
            new CauseStage(
                    """
                    <world-object name="body" mass="2">
                      <sphere radius="0.1"/>
                      <centre-of-mass x="0" y="0" z="-0.5"/>
                      <pinned><axis x="0" y="1" z="0"/></pinned>
                      <gravity/>
                    </world-object>
                    """,
                    new RigidMotion(
                            Vec3.ZERO,
                            Quat.ofAxisAngle(new Vec3(0, 1, 0), 0.8),
                            Vec3.ZERO,
                            Vec3.ZERO),
                    20);

    /** A ball that is thrown along a floor. */
    static final CauseStage THROWN =
            new CauseStage(
                    """
                    <world-object name="floor" fixed="1" restitution="1" friction="0.1"><half-space/></world-object>
                    <world-object name="body" mass="2" restitution="0.5" friction="0.1">
                      <position x="0" y="0" z="2"/>
                      <sphere radius="0.1"/>
                      <gravity/>
                    </world-object>
                    """,
                    new RigidMotion(new Vec3(0, 0, 2), Quat.IDENTITY, new Vec3(4, 2, 0), Vec3.ZERO),
                    4);

    private static final int SAMPLES = 201;
    private static final List<String> TOLD = List.of("port", "starboard", "lift", "rudder");

    /** Levels of the thrusters and the angle of the rudder (rad), four seconds each. */
    private static final double[][] LEVELS = {
        {0.5, 0.5, 0.2, 0.2},
        {0.7, 0.4, -0.3, -0.2},
        {0.1, 0.5, 0.4, 0.1},
        {0.6, 0.6, -0.2, -0.1},
        {0.5, 0.1, 0.1, 0.2}
    };

    /** Where a run begins is known to a millimetre, and nothing else of its start. */
    private static final List<Double> PLACED =
            IntStream.range(0, RigidMotion.SIZE)
                    .mapToObj(i -> i < 3 ? 1e-3 : Double.POSITIVE_INFINITY)
                    .toList();

    private BelievedModel model() {
        String xml = "<scenario><time-step delta=\"0.02\"/>" + objects + "</scenario>";
        try {
            return new BelievedModel(
                    ScenarioLoader.load(CauseStage.class.getClassLoader())
                            .parse(xml.getBytes(StandardCharsets.UTF_8)),
                    "body");
        } catch (AuvsmlException e) {
            throw new IllegalStateException("the stage is no scenario: " + xml, e);
        }
    }

    /** When it was measured and what it was told; where it was, if that is given. */
    private MeasuredRun run(RigidMotion... motions) {
        MeasuredRunBuilder run = MeasuredRun.named("run").commands(TOLD);
        for (int k = 0; k < SAMPLES; k++) {
            run.at(time(k));
            double[] levels = LEVELS[Math.min(LEVELS.length - 1, (int) (time(k) / 4))];
            for (int i = 0; i < levels.length; i++) {
                run.command(i, levels[i]);
            }
            if (motions.length > 0) {
                Vec3 p = motions[k].position();
                run.position(p.x(), p.y(), p.z()).orientation(motions[k].orientation());
            }
        }
        if (motions.length > 0) {
            run.start(new KnownStart(start, PLACED));
        }
        return run.build();
    }

    private RigidMotion[][] motions(BelievedModel model, List<Variant> variants) {
        return Ensemble.simulate(
                model,
                run(),
                0,
                SAMPLES - 1,
                variants.stream().map(v -> new Ensemble.Entrant(v, start)).toList());
    }

    /** The causes that make sense for it. */
    List<Cause> causes() {
        BelievedModel model = model();
        return Library.of(model, List.of(run(motions(model, List.of(model.variant()))[0])));
    }

    /** What is measured less what the model says, sample by sample: twelve numbers each. */
    double[][] residuals(Cause cause, double... theta) {
        BelievedModel model = model();
        Variant variant = cause.in(model.variant(), theta);
        RigidMotion[][] motions = motions(model, List.of(model.variant(), variant));
        RigidMotion[] told = variant.sensing().of(motions[1], run(), 0, SAMPLES);
        double[][] residuals = new double[SAMPLES][];
        for (int k = 0; k < SAMPLES; k++) {
            residuals[k] = told[k].minus(motions[0][k]);
        }
        return residuals;
    }

    /** When a sample is taken (s). */
    double time(int sample) {
        return seconds * sample / (SAMPLES - 1);
    }
}
