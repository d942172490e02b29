package org.auvsim.diagnosis.verdict;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.diagnosis.model.BelievedModel;
import org.auvsim.diagnosis.result.Alternative;
import org.auvsim.diagnosis.result.Diagnosis;
import org.auvsim.diagnosis.result.Finding;
import org.auvsim.diagnosis.run.Channel;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.run.MeasuredRunBuilder;
import org.auvsim.diagnosis.subject.Believed;
import org.junit.jupiter.api.Test;

import java.util.List;
import java.util.Random;

/**
 * A cart with a weak motor. While it gathers speed it might as well be heavier; only how fast it
 * goes in the end tells.
 */
class RivalsTest {
    private static final double MASS = 10;
    private static final double DRAG = 1;
    private static final double THRUST = 18; // 20 in the model
    private static final double SPACING = 0.1;
    private static final double NOISE = 0.05;

    private static BelievedModel model() throws Exception {
        return Believed.model(
                """
                <scenario><time-step delta="0.05"/>
                  <world-object name="cart" mass="10"><sphere radius="0.2"/>
                    <held y="1" z="1" turn-x="1" turn-y="1" turn-z="1"/>
                    <damping><linear x="1" y="0" z="0"/></damping>
                    <propulsor name="motor" maximum-thrust="20"/>
                  </world-object>
                </scenario>
                """,
                "cart");
    }

    /** From rest, always at one level: the speed approaches a steady one exponentially. */
    private static MeasuredRun run(int seed, double duration, double level) {
        Random random = new Random(seed);
        MeasuredRunBuilder run = MeasuredRun.named("run" + seed).commands(List.of("motor"));
        double steady = THRUST * level / DRAG;
        for (int k = 0; k * SPACING <= duration; k++) {
            double t = k * SPACING;
            double x = steady * (t + MASS / DRAG * Math.expm1(-DRAG / MASS * t));
            run.at(t)
                    .measured(
                            Channel.POSITION,
                            x + NOISE * random.nextGaussian(),
                            Double.NaN,
                            Double.NaN)
                    .command(0, level);
        }
        return run.build();
    }

    private static Diagnosis diagnosis(double judging) throws Exception {
        return Believed.suspectedOf(
                List.of("mass_error", "thruster_gain"),
                model(),
                List.of(run(1, 5, 0.4), run(2, 5, -0.4)),
                List.of(run(3, judging, 0.4)));
    }

    /** A heavier cart explains the short ones slightly better, and holds on the longer one. */
    @Test
    void allRunsAreAskedWhereALongerOneSpeaksForAnother() throws Exception {
        Diagnosis diagnosis = diagnosis(10);

        assertThat(diagnosis.selected())
                .extracting(Finding::cause)
                .containsExactly("thruster_gain");
        assertThat(diagnosis.evidence().alternatives()).isEmpty();
        assertThat(diagnosis.prediction().usedHeldOut()).isTrue();
    }

    @Test
    void theyAreNotWhereItSpeaksForNone() throws Exception {
        Diagnosis diagnosis = diagnosis(5);

        assertThat(diagnosis.selected()).extracting(Finding::cause).containsExactly("mass_error");
        assertThat(diagnosis.evidence().alternatives())
                .extracting(Alternative::causes)
                .containsExactly(List.of("thruster_gain (motor)"));
        assertThat(diagnosis.prediction().usedHeldOut()).isFalse();
    }
}
