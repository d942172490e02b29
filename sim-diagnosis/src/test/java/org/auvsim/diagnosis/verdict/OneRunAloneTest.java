package org.auvsim.diagnosis.verdict;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.diagnosis.model.BelievedModel;
import org.auvsim.diagnosis.result.Diagnosis;
import org.auvsim.diagnosis.result.Finding;
import org.auvsim.diagnosis.result.Verdict;
import org.auvsim.diagnosis.run.Channel;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.run.MeasuredRunBuilder;
import org.auvsim.diagnosis.subject.Believed;
import org.auvsim.diagnosis.subject.Cart;
import org.junit.jupiter.api.Test;

import java.util.List;
import java.util.Random;

/**
 * Carts with a weak motor and a drag, the longest of which is pushed from just before all others
 * end.
 */
class OneRunAloneTest {
    private static final double MASS = 10;
    private static final double THRUST = 18; // 20 in the model
    private static final double DRAG = 2; // none in the model
    private static final double PUSH = 0.3;
    private static final double PUSHED_FROM = 14.5;
    private static final double SPACING = 0.1;
    private static final int OF_LEVEL = 25;
    private static final double NOISE = 0.01;

    /** Under a constant force, speed approaches a steady one exponentially. */
    private static MeasuredRun run(int seed, double duration, double push) {
        Random random = new Random(seed);
        MeasuredRunBuilder run = MeasuredRun.named("run" + seed).commands(List.of("motor"));
        double x = 0;
        double v = 0;
        double level = 0;
        double kept = Math.exp(-DRAG / MASS * SPACING);
        for (int k = 0; k * SPACING < duration; k++) {
            level = k % OF_LEVEL == 0 ? random.nextDouble(-1, 1) : level;
            double told = x + NOISE * random.nextGaussian();
            run.at(k * SPACING).measured(Channel.POSITION, told, Double.NaN, Double.NaN);
            run.command(0, level);
            double force = THRUST * level + (k * SPACING < PUSHED_FROM ? 0 : push);
            double steady = force / DRAG;
            x += steady * SPACING + (v - steady) * (1 - kept) * MASS / DRAG;
            v = steady + (v - steady) * kept;
        }
        return run.build();
    }

    private static Diagnosis diagnosis(double push) throws Exception {
        BelievedModel model = Cart.onRails();
        return Believed.suspectedOf(
                List.of("thruster_gain", "linear_drag", "step_force"),
                model,
                List.of(run(1, 15, 0), run(2, 15, 0)),
                List.of(run(3, 20, push)));
    }

    /** What it is pushed by would be one of three causes; of it no other run foretells anything. */
    @Test
    void isNotBelieved() throws Exception {
        Diagnosis diagnosis = diagnosis(PUSH);

        assertThat(diagnosis.verdict()).isEqualTo(Verdict.UNEXPLAINED);
        assertThat(diagnosis.selected()).isEmpty();
    }

    @Test
    void whatAllShowIs() throws Exception {
        assertThat(diagnosis(0).selected())
                .extracting(Finding::cause)
                .containsExactlyInAnyOrder("thruster_gain", "linear_drag");
    }
}
