package org.auvsim.diagnosis.verdict;

import static org.assertj.core.api.Assertions.assertThat;

import static java.nio.charset.StandardCharsets.UTF_8;

import org.auvsim.auvsml.document.ScenarioLoader;
import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.diagnosis.Investigation;
import org.auvsim.diagnosis.cause.Library;
import org.auvsim.diagnosis.fit.Progress;
import org.auvsim.diagnosis.model.BelievedModel;
import org.auvsim.diagnosis.result.Diagnosis;
import org.auvsim.diagnosis.result.Verdict;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.run.MeasuredRunBuilder;
import org.junit.jupiter.api.Test;

import java.util.List;
import java.util.Random;

/**
 * A run that begins while the body is under way, as after a gap: it need not be as level as the
 * scenario has it, though nothing but its heading is measured. A cause was invented for that.
 */
class UnderWayTest {
    private static final double THRUST = 2;
    private static final double MASS = 10;
    private static final double NOISE = 0.01;

    @Test
    void whatIsTiltedAfterAGapLacksNothing() throws Exception {
        BelievedModel model =
                new BelievedModel(
                        ScenarioLoader.load(getClass().getClassLoader())
                                .parse(
                                        """
                                        <scenario><time-step delta="0.05"/>
                                          <world-object name="Pod" mass="10">
                                            <sphere radius="0.2"/>
                                            <propulsor name="screw" maximum-thrust="2"/>
                                          </world-object>
                                        </scenario>
                                        """
                                                .getBytes(UTF_8)),
                        "Pod");
        List<MeasuredRun> fit =
                List.of(
                        run(MeasuredRun.named("first"), 0, 1),
                        run(MeasuredRun.named("first-2").beginningMidway(), 0.2, 2),
                        run(MeasuredRun.named("second"), 0, 3));
        List<MeasuredRun> heldOut =
                List.of(
                        run(MeasuredRun.named("third"), 0, 4),
                        run(MeasuredRun.named("third-2").beginningMidway(), -0.15, 5));

        Diagnosis diagnosis =
                new Investigation(model, fit, heldOut, Library.of(model, fit), 1, Progress.SILENT)
                        .diagnose();

        assertThat(diagnosis.verdict()).as(diagnosis.sentence()).isEqualTo(Verdict.NONE);
    }

    /** Driven along an axis that keeps its pitch (rad); place and heading are measured. */
    private static MeasuredRun run(MeasuredRunBuilder run, double pitch, long seed) {
        Random random = new Random(seed);
        run.commands(List.of("screw"));
        double speed = 0;
        double way = 0;
        double level = 1;
        for (int k = 0; k < 120; k++) {
            if (k % 30 == 0) {
                level = random.nextDouble(-1, 1);
            }
            run.at(0.1 * k)
                    .command(0, level)
                    .position(
                            way * Math.cos(pitch) + NOISE * random.nextGaussian(),
                            NOISE * random.nextGaussian(),
                            -way * Math.sin(pitch) + NOISE * random.nextGaussian())
                    .orientation(
                            Quat.ofAxisAngle(new Vec3(0, 0, 1), NOISE * random.nextGaussian()),
                            false,
                            false,
                            true);
            double acceleration = level * THRUST / MASS;
            way += 0.1 * speed + 0.005 * acceleration;
            speed += 0.1 * acceleration;
        }
        return run.build();
    }
}
