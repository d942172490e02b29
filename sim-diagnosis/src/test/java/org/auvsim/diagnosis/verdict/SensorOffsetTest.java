package org.auvsim.diagnosis.verdict;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.diagnosis.model.BelievedModel;
import org.auvsim.diagnosis.result.Diagnosis;
import org.auvsim.diagnosis.result.Verdict;
import org.auvsim.diagnosis.run.KnownStart;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.run.MeasuredRunBuilder;
import org.auvsim.diagnosis.subject.Believed;
import org.auvsim.server.feedback.RigidMotion;
import org.junit.jupiter.api.Test;

import java.util.List;
import java.util.Random;
import java.util.stream.IntStream;

/** A depth sensor whose zero is off, which starts that are known alone tell. */
class SensorOffsetTest {
    private static final double NOISE = 0.01;
    private static final double KNOWN = 0.02;

    private static BelievedModel glider() throws Exception {
        return Believed.model(
                """
                <scenario><time-step delta="0.05"/>
                  <world-object name="glider" mass="10"><sphere radius="0.2"/></world-object>
                </scenario>
                """,
                "glider");
    }

    /** It glides along x at a depth of 3 m; its sensor tells so much more (m). */
    private static MeasuredRun run(String name, long seed, double offset) {
        Random random = new Random(seed);
        RigidMotion start =
                new RigidMotion(new Vec3(0, 0, -3), Quat.IDENTITY, new Vec3(1, 0, 0), Vec3.ZERO);
        List<Double> deviations =
                IntStream.range(0, RigidMotion.SIZE).mapToObj(i -> KNOWN).toList();
        MeasuredRunBuilder run = MeasuredRun.named(name).start(new KnownStart(start, deviations));
        for (int k = 0; k < 200; k++) {
            run.at(0.1 * k)
                    .position(
                            0.1 * k + NOISE * random.nextGaussian(),
                            NOISE * random.nextGaussian(),
                            -3 + offset + NOISE * random.nextGaussian());
        }
        return run.build();
    }

    private static Diagnosis diagnosis(double offset) throws Exception {
        List<MeasuredRun> fit =
                List.of(run("one", 1, offset), run("two", 2, offset), run("three", 3, offset));
        List<MeasuredRun> heldOut = List.of(run("four", 4, offset));
        return Believed.suspectedOf("sensor_offset", glider(), fit, heldOut);
    }

    /** Though a start that is moved by seven deviations predicts held-out runs as well. */
    @Test
    void isNamedWhereStartsTellIt() throws Exception {
        Diagnosis found = diagnosis(0.15);

        assertThat(found.verdict()).isEqualTo(Verdict.EXPLAINED);
        assertThat(found.selected().getFirst().quantities().get(2).value()).isBetween(0.12, 0.18);
    }

    @Test
    void isNoneWhereTheyAreAsKnown() throws Exception {
        assertThat(diagnosis(0).verdict()).isEqualTo(Verdict.NONE);
    }
}
