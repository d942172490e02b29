package org.auvsim.diagnosis.verdict;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.core.math.Vec3;
import org.auvsim.diagnosis.model.BelievedModel;
import org.auvsim.diagnosis.result.Diagnosis;
import org.auvsim.diagnosis.result.Verdict;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.subject.Believed;
import org.auvsim.diagnosis.subject.Surveyor;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

import java.util.List;
import java.util.Random;

/** A vehicle that fouls between its runs has no drag that explains all of them. */
@Tag("whole-search")
class RunByRunTest {
    private static MeasuredRun run(int seed, double quadratic, double turning) {
        return new Surveyor(quadratic, Vec3.ZERO, 1, turning).run("run" + seed, new Random(seed));
    }

    private static Diagnosis diagnosis(MeasuredRun... runs) throws Exception {
        BelievedModel model = Surveyor.believed();
        List<MeasuredRun> fit = List.of(runs[0], runs[1]);
        List<String> some =
                List.of("linear_drag", "quadratic_drag", "thruster_gain", "sensor_delay");
        return Believed.suspectedOf(some, model, fit, List.of(runs[2]));
    }

    @Test
    void whatChangedBetweenRunsIsTold() throws Exception {
        Diagnosis diagnosis = diagnosis(run(1, 0, 0), run(2, 12, 0), run(3, 12, 0));

        assertThat(diagnosis.verdict()).isEqualTo(Verdict.UNEXPLAINED);
        assertThat(diagnosis.notices())
                .filteredOn(notice -> notice.startsWith("each run by itself"))
                .singleElement()
                .asString()
                .containsPattern(
                        "^each run by itself is explained by quadratic_drag, but not by the same:"
                                + " k \\(kg/m\\) is -?0\\.0\\d* \\+- 0\\.0\\d+ in run1,"
                                + " 1[12]\\.\\d+ \\+- 0\\.0\\d+ in run2, 1[12]\\.\\d+"
                                + " \\+- 0\\.0\\d+ in run3; something changed");
    }

    @Test
    void whatNoneOfTheseExplainsIsNot() throws Exception {
        Diagnosis diagnosis = diagnosis(run(1, 0, 1.5), run(2, 0, 1.5), run(3, 0, 1.5));

        assertThat(diagnosis.verdict()).isEqualTo(Verdict.UNEXPLAINED);
        assertThat(diagnosis.notices())
                .noneMatch(notice -> notice.startsWith("each run by itself"));
    }
}
