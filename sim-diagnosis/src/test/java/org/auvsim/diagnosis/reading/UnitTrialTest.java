package org.auvsim.diagnosis.reading;

import static org.assertj.core.api.Assertions.assertThat;

import static java.nio.charset.StandardCharsets.UTF_8;

import org.auvsim.auvsml.document.ScenarioLoader;
import org.auvsim.diagnosis.model.BelievedModel;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.run.MeasuredRunBuilder;
import org.junit.jupiter.api.Test;

import java.util.List;
import java.util.Random;

/** A ball that is thrown along x at a depth that hardly changes, with as much noise as that. */
class UnitTrialTest {
    private static final int SAMPLES = 100;

    @Test
    void noiseOfADepthIsToldFromAPathThatBends() throws Exception {
        Random lot = new Random(4);
        MeasuredRunBuilder run = MeasuredRun.named("run");
        for (int k = 0; k < SAMPLES; k++) {
            double t = 0.1 * k;
            run.at(t)
                    .position(
                            10 * (1 - Math.exp(-t / 4)) + lot.nextGaussian(0, 0.3),
                            0,
                            -15 + lot.nextGaussian(0, 0.3));
        }
        UnitTrial trial =
                UnitTrial.of(ball(), run.build(), 0, SAMPLES - 1)
                        .of(List.of(new ModelUnits.Suspicion(List.of(2), 0.001)));

        assertThat(trial.isNoise(List.of(2))).isTrue();
        assertThat(trial.isNoise(List.of(0))).isFalse();
    }

    /** Of which the heights are told ten times as often as the places. */
    @Test
    void aPathOfFewFixesBeginsAsTheyDo() throws Exception {
        MeasuredRunBuilder run = MeasuredRun.named("run");
        for (int k = 0; k < 4 * SAMPLES; k++) {
            double t = 0.05 * k;
            boolean isFix = k % 10 == 3;
            run.at(t)
                    .position(
                            isFix ? 50 * (1 - Math.exp(-t / 5)) : Double.NaN,
                            isFix ? 0 : Double.NaN,
                            -15);
        }
        UnitTrial trial = UnitTrial.of(ball(), run.build(), 0, 4 * SAMPLES - 1).of(List.of());

        assertThat(trial.misfit(UnitTrial.AS_TOLD, List.of(0))).isLessThan(0.1);
    }

    private static BelievedModel ball() throws Exception {
        return new BelievedModel(
                ScenarioLoader.load(UnitTrialTest.class.getClassLoader())
                        .parse(
                                """
                                <scenario><time-step delta="0.05"/>
                                  <world-object name="ball" mass="1"><sphere radius="0.1"/>
                                    <isotropic-drag linear="0.2"/>
                                  </world-object>
                                </scenario>
                                """
                                        .getBytes(UTF_8)),
                "ball");
    }
}
