package org.auvsim.diagnosis.verdict;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.auvsim.diagnosis.model.BelievedModel;
import org.auvsim.diagnosis.result.Diagnosis;
import org.auvsim.diagnosis.result.Finding;
import org.auvsim.diagnosis.run.Channel;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.run.MeasuredRunBuilder;
import org.auvsim.diagnosis.subject.Believed;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.util.List;
import java.util.Random;

/**
 * A cart whose motor often does not overcome its dry friction, so that it rests half of the time.
 */
@Tag("whole-search")
class StickingCartTest {
    private static final double MASS = 4;
    private static final double THRUST = 12;
    private static final double DRAG = 1.5;
    private static final double MU = 0.15;
    private static final double SPACING = 0.1;
    private static final int SAMPLES = 250;
    private static final int OF_LEVEL = 25;
    private static final double NOISE = 0.2;
    private static final int SUBSTEPS = 500;

    private static BelievedModel cart() throws Exception {
        return Believed.model(
                """
                <scenario><time-step delta="0.02"/>
                  <world-object name="cart" mass="4"><sphere radius="0.2"/>
                    <held y="1" z="1" turn-x="1" turn-y="1" turn-z="1"/>
                    <damping><linear x="1.5" y="0" z="0"/></damping>
                    <propulsor name="motor" maximum-thrust="12"/>
                  </world-object>
                </scenario>
                """,
                "cart");
    }

    private static MeasuredRun run(long seed) {
        Random random = new Random(seed);
        MeasuredRunBuilder run = MeasuredRun.named("run" + seed).commands(List.of("motor"));
        double x = 0;
        double v = 0;
        double level = 0;
        for (int k = 0; k < SAMPLES; k++) {
            if (k % OF_LEVEL == 0) {
                level = random.nextDouble(-1, 1) * (random.nextInt(3) == 0 ? 0.18 : 1);
            }
            run.at(k * SPACING)
                    .measured(
                            Channel.POSITION,
                            x + NOISE * random.nextGaussian(),
                            Double.NaN,
                            Double.NaN);
            run.command(0, level);
            for (int s = 0; s < SUBSTEPS; s++) {
                double step = SPACING / SUBSTEPS;
                double next = moved(v, level * THRUST - DRAG * v, step);
                x += step * (v + next) / 2;
                v = next;
            }
        }
        return run.build();
    }

    /** The speed after a short step: what would turn round comes to rest. */
    private static double moved(double v, double force, double step) {
        double dry = MU * MASS * 9.80665;
        if (v == 0 && Math.abs(force) <= dry) {
            return 0;
        }
        double sign = v == 0 ? Math.signum(force) : Math.signum(v);
        double next = v + step * (force - sign * dry) / MASS;
        return next * sign < 0 ? 0 : next;
    }

    /** A small part of a friction hardly shows where the body rests: it promises little. */
    @ParameterizedTest
    @ValueSource(longs = {1, 11})
    void frictionIsFoundAmongOthers(long seed) throws Exception {
        BelievedModel model = cart();
        List<MeasuredRun> fit = List.of(run(seed), run(seed + 1));
        List<String> some =
                List.of(
                        "linear_drag",
                        "quadratic_drag",
                        "thruster_gain",
                        "thruster_deadzone",
                        "thruster_lag",
                        "sensor_scale",
                        "step_force",
                        "coulomb_friction");

        Diagnosis diagnosis = Believed.suspectedOf(some, model, fit, List.of(run(seed + 2)));

        assertThat(diagnosis.selected())
                .extracting(Finding::cause)
                .containsExactly("coulomb_friction");
        assertThat(diagnosis.selected().getFirst().quantities().getFirst().value())
                .isCloseTo(MU, within(0.002));
    }
}
