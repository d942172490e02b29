package org.auvsim.diagnosis.shooting;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.diagnosis.model.BelievedModel;
import org.auvsim.diagnosis.model.Ensemble.Entrant;
import org.auvsim.diagnosis.residual.Misses;
import org.auvsim.diagnosis.residual.Noise;
import org.auvsim.diagnosis.run.Channel;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.run.MeasuredRunBuilder;
import org.auvsim.diagnosis.shooting.WindowDerivatives.Moves;
import org.auvsim.diagnosis.subject.Believed;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import java.util.Collections;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Random;
import java.util.Set;

/** On rails only the way along them can begin otherwise, and where they are if that is measured. */
class StartsThatStayTest {
    private static final int SAMPLES = 21;
    private static final double SPACING = 0.1;

    private static BelievedModel onRails() throws Exception {
        return Believed.model(
                """
                <scenario><time-step delta="0.05"/>
                  <world-object name="cart" mass="4"><sphere radius="0.2"/>
                    <velocity x="1" y="0" z="0"/>
                    <held y="1" z="1" turn-x="1" turn-y="1" turn-z="1"/>
                  </world-object>
                </scenario>
                """,
                "cart");
    }

    private static Shooting shooting(BelievedModel model, boolean isBesideMeasured) {
        Random random = new Random(1);
        MeasuredRunBuilder run = MeasuredRun.named("run");
        for (int k = 0; k < SAMPLES; k++) {
            double beside = isBesideMeasured ? random.nextGaussian() : Double.NaN;
            run.at(k * SPACING)
                    .measured(
                            Channel.POSITION,
                            k * SPACING + 0.01 * random.nextGaussian(),
                            beside,
                            Double.NaN);
        }
        List<MeasuredRun> runs = List.of(run.build());
        return new Shooting(
                Stepping.exact(model), model.variant(), Misses.of(runs, Noise.of(runs)).getFirst());
    }

    @ParameterizedTest(name = "beside measured: {0}")
    @CsvSource({"false, 2", "true, 3"})
    void areNotSimulatedOtherwise(boolean isBesideMeasured, int moved) throws Exception {
        BelievedModel model = onRails();
        Shooting shooting = shooting(model, isBesideMeasured);
        Window window = new Window(0, SAMPLES - 1, model.start());

        Set<Entrant> simulated = Collections.newSetFromMap(new IdentityHashMap<>());
        simulated.addAll(shooting.fromAllStarts(0, model.start()));
        WindowDerivatives derivatives = shooting.derivatives(window, 1, Moves.NONE);

        assertThat(simulated).hasSize(1 + moved);
        for (int i = 0; i < derivatives.byStart.length; i++) {
            boolean tells = i == 0 || i == 6 || (i == 1 && isBesideMeasured);
            assertThat(derivatives.byStart[i]).as("number %d", i).matches(d -> isNone(d) != tells);
        }
    }

    private static boolean isNone(double[] numbers) {
        for (double number : numbers) {
            if (number != 0) {
                return false;
            }
        }
        return true;
    }
}
