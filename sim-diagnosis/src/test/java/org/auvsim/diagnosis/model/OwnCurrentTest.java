package org.auvsim.diagnosis.model;

import static org.assertj.core.api.Assertions.assertThat;

import static java.nio.charset.StandardCharsets.UTF_8;

import org.auvsim.auvsml.AuvsmlException;
import org.auvsim.auvsml.document.ScenarioLoader;
import org.auvsim.core.field.UniformCurrent;
import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.diagnosis.model.Ensemble.Entrant;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.run.MeasuredRunBuilder;
import org.auvsim.server.feedback.RigidMotion;
import org.junit.jupiter.api.Test;

import java.util.List;

/** Added mass is carried by the water: by that of the variant's own world alone. */
class OwnCurrentTest {
    private static final String MODEL =
            """
            <scenario>
              <time-step delta="0.05"/>
              <world-object name="hull" mass="10">
                <sphere radius="0.2"/>
                <added-mass><linear x="10" y="10" z="10"/></added-mass>
              </world-object>
            </scenario>
            """;

    private static final RigidMotion START =
            new RigidMotion(Vec3.ZERO, Quat.IDENTITY, new Vec3(0.3, 0, 0), Vec3.ZERO);

    private static BelievedModel model() throws AuvsmlException {
        return new BelievedModel(
                ScenarioLoader.load(OwnCurrentTest.class.getClassLoader())
                        .parse(MODEL.getBytes(UTF_8)),
                "hull");
    }

    private static MeasuredRun run() {
        MeasuredRunBuilder run = MeasuredRun.named("run");
        for (int k = 0; k <= 20; k++) {
            run.at(0.1 * k).position(0, 0, 0);
        }
        return run.build();
    }

    @Test
    void aVariantBeginsAsToldWhateverItsWater() throws AuvsmlException {
        BelievedModel model = model();
        Variant still = model.variant();
        Variant drifting = still.in(new UniformCurrent(1, "own", new Vec3(0, 0.5, 0)));
        Variant stemming = still.in(new UniformCurrent(1, "own", new Vec3(-2, 0, 1)));
        RigidMotion[][] motions =
                Ensemble.simulate(
                        model,
                        run(),
                        0,
                        20,
                        List.of(
                                new Entrant(drifting, START),
                                new Entrant(still, START),
                                new Entrant(stemming, START)));

        // Nothing but inertia acts: steady water changes nothing of a steady motion.
        for (RigidMotion[] motion : motions) {
            for (int k = 0; k <= 20; k++) {
                Vec3 way = new Vec3(0.03 * k, 0, 0);
                assertThat(motion[k].velocity().minus(START.velocity()).norm()).isLessThan(1e-12);
                assertThat(motion[k].position().minus(way).norm()).isLessThan(1e-12);
            }
        }
    }
}
