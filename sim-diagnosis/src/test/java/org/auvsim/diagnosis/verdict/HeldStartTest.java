package org.auvsim.diagnosis.verdict;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.diagnosis.model.BelievedModel;
import org.auvsim.diagnosis.result.Verdict;
import org.auvsim.diagnosis.run.Channel;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.run.MeasuredRunBuilder;
import org.auvsim.diagnosis.subject.Believed;
import org.junit.jupiter.api.Test;

import java.util.List;
import java.util.Random;

/** What is held does not move, but where it is held is known by noisy measurements alone. */
class HeldStartTest {
    private static final int SAMPLES = 200;
    private static final double SPACING = 0.1;

    private static BelievedModel sledge() throws Exception {
        return Believed.model(
                """
                <scenario><time-step delta="0.05"/>
                  <world-object name="sledge" mass="10"><sphere radius="0.2"/>
                    <held y="1" z="1" turn-x="1" turn-y="1"/>
                  </world-object>
                </scenario>
                """,
                "sledge");
    }

    /** It glides along x; the other two are measured, too. */
    private static MeasuredRun run(String name, long seed) {
        Random random = new Random(seed);
        MeasuredRunBuilder run = MeasuredRun.named(name);
        for (int k = 0; k < SAMPLES; k++) {
            double t = k * SPACING;
            run.at(t)
                    .position(
                            t + 0.01 * random.nextGaussian(),
                            0.01 * random.nextGaussian(),
                            -3 + 0.01 * random.nextGaussian());
            run.measured(
                    Channel.VELOCITY, 1 + 0.01 * random.nextGaussian(), Double.NaN, Double.NaN);
        }
        return run.build();
    }

    private static BelievedModel arm() throws Exception {
        return Believed.model(
                """
                <scenario><time-step delta="0.05"/>
                  <world-object name="arm" mass="3"><box><size x="0.8" y="0.1" z="0.1"/></box>
                    <orientation w="0.70710678" x="0" y="0.70710678" z="0"/>
                    <pinned><axis x="0" y="1" z="0"/></pinned>
                  </world-object>
                </scenario>
                """,
                "arm");
    }

    /** It turns evenly about its pin; its attitude is measured about all axes. */
    private static MeasuredRun turning(String name, long seed) {
        Random random = new Random(seed);
        MeasuredRunBuilder run = MeasuredRun.named(name);
        for (int k = 0; k < SAMPLES; k++) {
            double t = k * SPACING;
            Vec3 noise =
                    new Vec3(random.nextGaussian(), random.nextGaussian(), random.nextGaussian());
            run.at(t)
                    .orientation(
                            Quat.ofAxisAngle(noise.normalized(), 0.02 * noise.norm())
                                    .times(Quat.ofAxisAngle(new Vec3(0, 1, 0), 1 + 0.4 * t)));
        }
        return run.build();
    }

    /** Noise about the axes that the pin holds does not tilt the arm. */
    @Test
    void nothingIsMissedOfWhatIsPinned() throws Exception {
        List<MeasuredRun> fit = List.of(turning("one", 1), turning("two", 2));
        List<MeasuredRun> heldOut = List.of(turning("three", 3));
        assertThat(Believed.suspectedOf("coulomb_torque", arm(), fit, heldOut).verdict())
                .isEqualTo(Verdict.NONE);
    }

    @Test
    void nothingIsMissed() throws Exception {
        BelievedModel model = sledge();
        List<MeasuredRun> fit = List.of(run("one", 1), run("two", 2));
        List<MeasuredRun> heldOut = List.of(run("three", 3));
        assertThat(Believed.suspectedOf("linear_drag", model, fit, heldOut).verdict())
                .isEqualTo(Verdict.NONE);
    }
}
