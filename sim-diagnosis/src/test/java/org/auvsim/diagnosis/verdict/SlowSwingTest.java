package org.auvsim.diagnosis.verdict;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.diagnosis.cause.Cause;
import org.auvsim.diagnosis.cause.Library;
import org.auvsim.diagnosis.cause.Parameter;
import org.auvsim.diagnosis.fit.Hypothesis;
import org.auvsim.diagnosis.model.BelievedModel;
import org.auvsim.diagnosis.result.Diagnosis;
import org.auvsim.diagnosis.result.Verdict;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.run.MeasuredRunBuilder;
import org.auvsim.diagnosis.subject.Believed;
import org.junit.jupiter.api.Test;

import java.util.List;
import java.util.Random;

/** Of a sled that was measured for 10 s. */
class SlowSwingTest {
    private static MeasuredRun run(double from) {
        MeasuredRunBuilder run = MeasuredRun.named("run1");
        for (int k = 0; k <= 100; k++) {
            double t = from + 0.1 * k;
            run.at(t).position(Math.sin(t), Math.cos(t), 0);
        }
        return run.build();
    }

    private static BelievedModel model() throws Exception {
        return Believed.model(
                """
                <scenario><time-step delta="0.05"/>
                  <world-object name="sled" mass="2"><sphere radius="0.2"/></world-object>
                </scenario>
                """,
                "sled");
    }

    private static Cause force(BelievedModel model, List<MeasuredRun> runs) {
        return Library.named(List.of("periodic_force"), Library.of(model, runs)).getFirst();
    }

    private static List<String> notices(List<MeasuredRun> runs, double omega) throws Exception {
        return SlowSwing.notices(runs, swing(runs, omega));
    }

    private static Hypothesis swing(List<MeasuredRun> runs, double omega) throws Exception {
        Cause force = force(model(), runs);
        double[] theta =
                force.guesses(runs).getFirst().theta().stream()
                        .mapToDouble(Double::doubleValue)
                        .toArray();
        int at = force.parameters().stream().map(Parameter::name).toList().indexOf("omega");
        theta[at] = omega;
        return Hypothesis.NONE.and(force, theta);
    }

    @Test
    void aSwingOfWhichRunsShowOnlyAPartIsTold() throws Exception {
        assertThat(notices(List.of(run(0), run(0)), 0.3))
                .singleElement()
                .asString()
                .startsWith("the period of periodic_force, 21 s, is longer than the 10 s that");
    }

    @Test
    void oneThatTheyShowWholeIsNot() throws Exception {
        assertThat(notices(List.of(run(0)), 0.7)).isEmpty();
        assertThat(notices(List.of(run(0), run(20)), 0.3)).isEmpty(); // at two of its times
    }

    @Test
    void oneOfWhichTheyShowNoQuarterIsATrend() throws Exception {
        List<MeasuredRun> runs = List.of(run(0));

        assertThat(SlowSwing.isTrend(runs, swing(runs, 0.15))).isTrue();
        assertThat(SlowSwing.isTrend(runs, swing(runs, 0.16))).isFalse();
        assertThat(SlowSwing.isTrend(runs, Hypothesis.NONE)).isFalse();
    }

    /** Pushed ever harder: how hard in the end of a swing nobody has seen. */
    @Test
    void aForceThatGrowsIsNoSwing() throws Exception {
        BelievedModel model = model();
        List<MeasuredRun> fit = List.of(pushedEverHarder(1), pushedEverHarder(2));

        Diagnosis diagnosis =
                Believed.suspectedOf("periodic_force", model, fit, List.of(pushedEverHarder(3)));

        assertThat(diagnosis.verdict()).isEqualTo(Verdict.UNEXPLAINED);
        assertThat(diagnosis.selected()).isEmpty();
        assertThat(diagnosis.notices()).anyMatch(said -> said.contains("the period of periodic_f"));
    }

    /** By 0.05 N more each second, from rest. */
    private static MeasuredRun pushedEverHarder(int seed) {
        Random random = new Random(seed);
        MeasuredRunBuilder run = MeasuredRun.named("run" + seed);
        for (int k = 0; k <= 100; k++) {
            double t = 0.1 * k;
            run.at(t).position(0.05 * t * t * t / 12 + noise(random), noise(random), noise(random));
        }
        return run.build();
    }

    /** A diagnosis says so: it was pushed to and fro once in 16 s. */
    @Test
    void aDiagnosisTellsIt() throws Exception {
        BelievedModel model = model();
        MeasuredRun one = pushed(1);
        MeasuredRun other = pushed(2);

        Diagnosis diagnosis =
                Believed.suspectedOf("periodic_force", model, List.of(one), List.of(other));

        assertThat(diagnosis.verdict()).isEqualTo(Verdict.EXPLAINED);
        assertThat(diagnosis.notices()).anyMatch(said -> said.contains("the period of periodic_f"));
    }

    /** By a force of 0.5 N, from rest. */
    private static MeasuredRun pushed(int seed) {
        Random random = new Random(seed);
        double omega = 2 * Math.PI / 16;
        double way = 0.5 / (2 * omega * omega);
        MeasuredRunBuilder run = MeasuredRun.named("run" + seed);
        for (int k = 0; k <= 100; k++) {
            double t = 0.1 * k;
            run.at(t)
                    .position(
                            way * (omega * t - Math.sin(omega * t)) + noise(random),
                            noise(random),
                            noise(random));
        }
        return run.build();
    }

    private static double noise(Random random) {
        return 0.003 * random.nextGaussian();
    }
}
