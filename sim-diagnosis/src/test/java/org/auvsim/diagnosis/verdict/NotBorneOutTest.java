package org.auvsim.diagnosis.verdict;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.diagnosis.model.BelievedModel;
import org.auvsim.diagnosis.result.Diagnosis;
import org.auvsim.diagnosis.result.Ranked;
import org.auvsim.diagnosis.result.Verdict;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.run.MeasuredRunBuilder;
import org.auvsim.diagnosis.subject.Believed;
import org.auvsim.diagnosis.subject.FreeSphere;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

import java.util.List;
import java.util.Random;

/** A sphere coasts; by what it is slowed, it was in the run of the fit alone. */
@Tag("whole-search")
class NotBorneOutTest {
    private static final int SAMPLES = 6001;
    private static final double SPACING = 0.05;
    private static final double NOISE = 0.01;

    /** So little (m/s^2) that its residuals pass for noise, and a test of one cause sees it. */
    private static final double SLIGHT = 4e-7;

    private static MeasuredRun run(String name, double slowed, Random random) {
        MeasuredRunBuilder run = MeasuredRun.named(name);
        for (int k = 0; k < SAMPLES; k++) {
            double t = k * SPACING;
            double x = t - slowed * t * t / 2 + NOISE * random.nextGaussian();
            run.at(t).position(x, Double.NaN, Double.NaN);
        }
        return run.build();
    }

    private static Diagnosis diagnosis(double slowed, double slowedElsewhere) throws Exception {
        BelievedModel model = FreeSphere.believed(0.05);
        Random random = new Random(5);
        List<MeasuredRun> fit = List.of(run("fit", slowed, random));
        List<MeasuredRun> heldOut = List.of(run("held out", slowedElsewhere, random));
        return Believed.suspectedOf("linear_drag", model, fit, heldOut);
    }

    @Test
    void whatHeldOutRunsDoNotBearOutIsNothingWhereTheModelLeavesNoise() throws Exception {
        Diagnosis diagnosis = diagnosis(SLIGHT, 0);

        assertThat(diagnosis.evidence().ranked())
                .extracting(Ranked::causes)
                .contains(List.of("linear_drag"));
        assertThat(diagnosis.evidence().ranked().getFirst().causes()).isEmpty();
        assertThat(diagnosis.verdict()).isEqualTo(Verdict.NONE);
        assertThat(diagnosis.selected()).isEmpty();
    }

    @Test
    void whatTheyBearOutIsNamed() throws Exception {
        assertThat(diagnosis(SLIGHT, SLIGHT).verdict()).isEqualTo(Verdict.EXPLAINED);
    }

    @Test
    void whereItLeavesMoreSomethingIsWrong() throws Exception {
        assertThat(diagnosis(20 * SLIGHT, 0).verdict()).isEqualTo(Verdict.UNEXPLAINED);
    }
}
