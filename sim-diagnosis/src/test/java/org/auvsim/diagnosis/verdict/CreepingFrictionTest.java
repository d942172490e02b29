package org.auvsim.diagnosis.verdict;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.auvsim.diagnosis.cause.Quantity;
import org.auvsim.diagnosis.result.Diagnosis;
import org.auvsim.diagnosis.result.Finding;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.run.MeasuredRunBuilder;
import org.auvsim.diagnosis.subject.Believed;
import org.auvsim.diagnosis.subject.Cart;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

import java.util.List;
import java.util.Random;

/** A cart on a rail with dry friction, which its motor overcomes now and then. */
@Tag("whole-search")
class CreepingFrictionTest {
    private static final double MASS = 10;
    private static final double THRUST = 20;
    private static final double MU = 0.03;
    private static final double SPACING = 0.1;
    private static final int SAMPLES = 200;
    private static final double NOISE = 0.005;
    private static final int SUBSTEPS = 1000;

    /** Levels of the motor: below 0.147 of its thrust it does not overcome friction. */
    private static final List<Double> LEVELS =
            List.of(0.3, 0.12, 0.13, -0.1, -0.3, 0.08, 0.25, -0.14);

    /**
     * Below the slip speed friction falls to nothing; by steps of 0.1 ms.
     *
     * @param more by which the levels are higher
     */
    private static MeasuredRun run(int first, double slip, double more) {
        Random random = new Random(first);
        MeasuredRunBuilder run = MeasuredRun.named("run" + first).commands(List.of("motor"));
        double x = 0;
        double v = 0;
        for (int k = 0; k < SAMPLES; k++) {
            double level = more * LEVELS.get((first + k / 25) % LEVELS.size());
            run.at(k * SPACING)
                    .position(
                            x + NOISE * random.nextGaussian(),
                            NOISE * random.nextGaussian(),
                            NOISE * random.nextGaussian());
            run.command(0, level);
            for (int s = 0; s < SUBSTEPS; s++) {
                double friction = MU * MASS * 9.80665 * v / Math.max(Math.abs(v), slip);
                v += SPACING / SUBSTEPS * (level * THRUST - friction) / MASS;
                x += SPACING / SUBSTEPS * v;
            }
        }
        return run.build();
    }

    private static Diagnosis diagnosed(double slip, double more) throws Exception {
        return Believed.suspectedOf(
                "coulomb_friction",
                Cart.onRails(),
                List.of(run(0, slip, more), run(1, slip, more)),
                List.of(run(2, slip, more)));
    }

    private static List<Quantity> found(Diagnosis diagnosis) {
        assertThat(diagnosis.selected())
                .extracting(Finding::cause)
                .containsExactly("coulomb_friction");
        return diagnosis.selected().getFirst().quantities();
    }

    /** Faster than is believed of what rests. */
    @Test
    void whatCreepsTellsHowFast() throws Exception {
        List<Quantity> quantities = found(diagnosed(0.03, 1));

        assertThat(quantities).extracting(Quantity::name).containsExactly("mu", "slip");
        assertThat(quantities.getFirst().value()).isCloseTo(MU, within(0.0001));
        assertThat(quantities.getLast().value()).isCloseTo(0.03, within(0.001));
    }

    /** It is the same cause, so that it is no alternative to itself. */
    @Test
    void whatNeverRestsTellsNothingOfIt() throws Exception {
        Diagnosis diagnosis = diagnosed(0.03, 3);

        assertThat(found(diagnosis)).extracting(Quantity::name).containsExactly("mu");
        assertThat(diagnosis.evidence().alternatives()).isEmpty();
    }
}
