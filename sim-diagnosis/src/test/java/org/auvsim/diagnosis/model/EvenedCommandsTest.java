package org.auvsim.diagnosis.model;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import static java.nio.charset.StandardCharsets.UTF_8;

import org.auvsim.auvsml.AuvsmlException;
import org.auvsim.auvsml.document.ScenarioLoader;
import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.diagnosis.model.Ensemble.Commands;
import org.auvsim.diagnosis.model.Ensemble.Entrant;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.run.MeasuredRunBuilder;
import org.auvsim.server.feedback.RigidMotion;
import org.junit.jupiter.api.Test;

import java.util.List;
import java.util.function.IntToDoubleFunction;

/** A box of 2 kg in space, which a thruster and a force push as rows command it. */
class EvenedCommandsTest {
    private static final String MODEL =
            """
            <scenario><time-step delta="0.4"/>
              <world-object name="box" mass="2"><box><size x="1" y="1" z="1"/></box>
                <propulsor name="ahead" maximum-thrust="10"/>
                <force name="aside"><vector x="0" y="0" z="0.5"/></force>
              </world-object></scenario>
            """;

    private static final double SPACING = 0.1;
    private static final int[] KNOTS = {0, 4, 8};
    private static final RigidMotion AT_REST =
            new RigidMotion(Vec3.ZERO, Quat.IDENTITY, Vec3.ZERO, Vec3.ZERO);

    private static RigidMotion[] motion(IntToDoubleFunction levels, Commands commands)
            throws AuvsmlException {
        BelievedModel model =
                new BelievedModel(
                        ScenarioLoader.load(EvenedCommandsTest.class.getClassLoader())
                                .parse(MODEL.getBytes(UTF_8)),
                        "box");
        MeasuredRunBuilder run = MeasuredRun.named("run").commands(List.of("ahead", "aside.y"));
        for (int k = 0; k <= KNOTS[KNOTS.length - 1]; k++) {
            double level = levels.applyAsDouble(k);
            run.at(SPACING * k).position(0, 0, 0).command(0, level).command(1, -4 * level);
        }
        List<Entrant> alone = List.of(new Entrant(model.variant(), AT_REST));
        return Ensemble.simulate(model, run.build(), KNOTS, alone, commands)[0];
    }

    private static double ahead(int row) {
        return 0.1 * row;
    }

    /** 10 N/2 kg of the mean level of four rows, for 0.4 s each. */
    @Test
    void theirMeanGivesTheSameMomentum() throws Exception {
        RigidMotion[] motion = motion(EvenedCommandsTest::ahead, Commands.EVENED);

        assertThat(motion[1].velocity().x()).isCloseTo(5 * 0.15 * 0.4, within(1e-12));
        assertThat(motion[2].velocity().x()).isCloseTo(5 * (0.15 + 0.55) * 0.4, within(1e-12));
        assertThat(motion[2].velocity().y()).isCloseTo(-2 * (0.15 + 0.55) * 0.4, within(1e-12));
        assertThat(motion[2].velocity().z()).isCloseTo(0.25 * 0.8, within(1e-12));
        assertThat(motion[1].position().x()).isCloseTo(5 * 0.15 * 0.08, within(1e-12));
    }

    /** Row by row the later, stronger levels act for a shorter time. */
    @Test
    void fromRowToRowTheyLeadLessFar() throws Exception {
        RigidMotion[] motion = motion(EvenedCommandsTest::ahead, Commands.FROM_ROW_TO_ROW);

        assertThat(motion[1].velocity().x()).isCloseTo(5 * 0.15 * 0.4, within(1e-12));
        assertThat(motion[1].position().x())
                .isCloseTo(5 * 0.01 * (0.1 * 2.5 + 0.2 * 1.5 + 0.3 * 0.5), within(1e-12));
    }

    /** After two changes in the first four rows nothing changes any more. */
    @Test
    void whatIsHeldAfterwardsIsWhatWasCommandedLast() throws Exception {
        IntToDoubleFunction levels = row -> Math.min(1, 0.5 * row);

        RigidMotion[] motion = motion(levels, Commands.EVENED);

        assertThat(motion[2].velocity().x())
                .isCloseTo(5 * (2.5 * 0.1 + 0.4), within(1e-12))
                .isCloseTo(
                        motion(levels, Commands.FROM_ROW_TO_ROW)[2].velocity().x(), within(1e-12));
    }

    @Test
    void oneChangeIsMadeWhereItIs() throws Exception {
        IntToDoubleFunction once = row -> row < 3 ? 0 : 1;

        assertThat(motion(once, Commands.EVENED)).isEqualTo(motion(once, Commands.FROM_ROW_TO_ROW));
    }
}
