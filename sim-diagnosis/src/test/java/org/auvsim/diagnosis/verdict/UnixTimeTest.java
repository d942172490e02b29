package org.auvsim.diagnosis.verdict;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.diagnosis.model.BelievedModel;
import org.auvsim.diagnosis.result.Diagnosis;
import org.auvsim.diagnosis.result.Verdict;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.run.MeasuredRunBuilder;
import org.auvsim.diagnosis.subject.Believed;
import org.auvsim.diagnosis.subject.FreeSphere;
import org.junit.jupiter.api.Test;

import java.util.List;
import java.util.Random;

/** A sphere coasts, and from a moment of its second run on is pushed for ever, by UNIX time. */
class UnixTimeTest {
    private static final double BEGIN = 1_718_000_000;
    private static final double ONSET = BEGIN + 412;
    private static final double PUSHED = 0.05;
    private static final double NOISE = 0.005;

    private static MeasuredRun run(String name, double begin, Random random) {
        MeasuredRunBuilder run = MeasuredRun.named(name);
        for (int k = 0; k <= 400; k++) {
            double t = begin + 0.05 * k;
            double pushed = Math.max(0, t - Math.max(begin, ONSET));
            double x = t - begin + PUSHED * pushed * pushed / 2 + NOISE * random.nextGaussian();
            run.at(t).position(x, Double.NaN, Double.NaN);
        }
        return run.build();
    }

    @Test
    void whatBeganIsToldFromTheStartOfItsRunAndMetByTheExtendedScenario() throws Exception {
        BelievedModel model = FreeSphere.believed(0.05);
        Random random = new Random(5);
        List<MeasuredRun> fit =
                List.of(run("calm", BEGIN, random), run("pushed", BEGIN + 400, random));
        List<MeasuredRun> heldOut = List.of(run("later", BEGIN + 900, random));

        Diagnosis diagnosis = Believed.suspectedOf("step_force", model, fit, heldOut);

        assertThat(diagnosis.verdict()).isEqualTo(Verdict.EXPLAINED);
        assertThat(diagnosis.sentence())
                .containsPattern(
                        "from (12[.]0|11[.]9)[0-9]* \\+- 0[.]0[0-9]+ s after the start of pushed;");
        assertThat(diagnosis.extended().startTime()).isEqualTo(BEGIN);
    }

    @Test
    void whatIsTimelessLeavesTheScenariosBeginning() throws Exception {
        BelievedModel model = FreeSphere.believed(0.05);
        Random random = new Random(5);
        List<MeasuredRun> fit = List.of(run("one", BEGIN, random));
        List<MeasuredRun> heldOut = List.of(run("other", BEGIN + 100, random));

        Diagnosis diagnosis = Believed.suspectedOf("linear_drag", model, fit, heldOut);

        assertThat(diagnosis.extended().startTime()).isZero();
    }
}
