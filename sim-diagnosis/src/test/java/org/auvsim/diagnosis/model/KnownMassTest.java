package org.auvsim.diagnosis.model;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.auvsim.auvsml.document.ScenarioLoader;
import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.diagnosis.cause.Cause;
import org.auvsim.diagnosis.cause.Library;
import org.auvsim.diagnosis.model.Ensemble.Entrant;
import org.auvsim.diagnosis.run.Channel;
import org.auvsim.diagnosis.run.KnownDifferences;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.run.MeasuredRunBuilder;
import org.auvsim.server.feedback.RigidMotion;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.nio.charset.StandardCharsets;
import java.util.List;

/** A box that a thruster beside its centre turns, in runs in which it had another mass. */
class KnownMassTest {
    private static final RigidMotion START =
            new RigidMotion(Vec3.ZERO, Quat.IDENTITY, Vec3.ZERO, new Vec3(0.1, 0.2, 0.3));

    private BelievedModel model;

    @BeforeEach
    void believe() throws Exception {
        String xml =
                """
                <scenario>
                  <time-step delta="0.05"/>
                  <world-object name="box" mass="5">
                    <box><size x="0.8" y="0.4" z="0.3"/></box>
                    <propulsor name="port" maximum-thrust="2" level="1">
                      <position x="0" y="0.2" z="0"/>
                    </propulsor>
                  </world-object>
                </scenario>
                """;
        model =
                new BelievedModel(
                        ScenarioLoader.load(KnownMassTest.class.getClassLoader())
                                .parse(xml.getBytes(StandardCharsets.UTF_8)),
                        "box");
    }

    private static MeasuredRun run(double more) {
        MeasuredRunBuilder run = MeasuredRun.named("run");
        for (int k = 0; k < 40; k++) {
            run.at(0.05 * k).position(0.01 * k, 0, 0).measured(Channel.ANGULAR_VELOCITY, 0, 0, 0.1);
        }
        return run.differences(new KnownDifferences(more, List.of(), List.of())).build();
    }

    private Cause cause(String id, MeasuredRun run) {
        return Library.named(List.of(id), Library.of(model, List.of(run))).getFirst();
    }

    private RigidMotion end(MeasuredRun run, Variant variant) {
        return Ensemble.simulate(model, run, 0, 39, List.of(new Entrant(variant, START)))[0][39];
    }

    /** Without a tensor of its own, a body has that of its volume. */
    @ParameterizedTest
    @ValueSource(strings = {"mass_error", "inertia_error"})
    void aSmallErrorChangesTheMotionALittle(String id) {
        MeasuredRun run = run(2);
        Cause cause = cause(id, run);
        double[] theta = new double[cause.parameters().size()];
        RigidMotion believed = end(run, cause.in(model.variant(), theta));

        theta[theta.length - 1] = 1e-7;
        RigidMotion changed = end(run, cause.in(model.variant(), theta));

        assertThat(changed.angularVelocity().distance(believed.angularVelocity()))
                .isCloseTo(0, within(1e-6));
    }

    /** In a run it weighed 1 kg: of that something stays, however wrong the mass is. */
    @Test
    void noErrorTakesMoreThanABodyHadInItsLightestRun() {
        MeasuredRun run = run(-4);
        Cause cause = cause("mass_error", run);
        double least = cause.parameters().getFirst().clipped(-1);

        RigidMotion motion = end(run, cause.in(model.variant(), new double[] {least}));

        assertThat(motion).isNotEqualTo(Ensemble.LOST);
    }
}
