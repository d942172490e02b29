package org.auvsim.diagnosis.verdict;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.core.math.Vec3;
import org.auvsim.diagnosis.result.Diagnosis;
import org.auvsim.diagnosis.result.Verdict;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.subject.Believed;
import org.auvsim.diagnosis.subject.Surveyor;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

import java.util.List;
import java.util.Random;

/** Runs of a vehicle that is as believed, and one of another that differs from it in two ways. */
@Tag("whole-search")
class OddRunTest {
    private static final List<String> SOME =
            List.of("linear_drag", "quadratic_drag", "rotational_drag", "thruster_gain");

    private static final MeasuredRun FIRST = sound(1);
    private static final MeasuredRun OTHER =
            new Surveyor(12, Vec3.ZERO, 0.7, 0).run("other", new Random(2));
    private static final MeasuredRun THIRD = sound(3);
    private static final MeasuredRun LAST = sound(4);

    private static MeasuredRun sound(int seed) {
        return new Surveyor(0, Vec3.ZERO, 1, 0).run("run" + seed, new Random(seed));
    }

    @Test
    void thatOneFittedRunAloneIsMissedIsTold() throws Exception {
        isTold(List.of(FIRST, OTHER, THIRD), LAST, "run1, run3, run4");
    }

    @Test
    void thatTheHeldOutRunAloneIsMissedIsTold() throws Exception {
        isTold(List.of(FIRST, THIRD), OTHER, "run1, run3");
    }

    @Test
    void whereOnlyOneOtherIsPredictedNobodyKnowsWhichIsOdd() throws Exception {
        Diagnosis diagnosis =
                Believed.suspectedOf(
                        List.of("rotational_drag"),
                        Surveyor.believed(),
                        List.of(FIRST),
                        List.of(OTHER));

        assertThat(diagnosis.notices()).noneMatch(notice -> notice.contains("alone"));
    }

    private static void isTold(List<MeasuredRun> fit, MeasuredRun heldOut, String others)
            throws Exception {
        Diagnosis diagnosis =
                Believed.suspectedOf(SOME, Surveyor.believed(), fit, List.of(heldOut));

        assertThat(diagnosis.verdict()).isEqualTo(Verdict.UNEXPLAINED);
        assertThat(diagnosis.notices())
                .filteredOn(notice -> notice.startsWith("the model as it is predicts"))
                .singleElement()
                .asString()
                .startsWith(
                        "the model as it is predicts "
                                + others
                                + " to the noise, and misses other alone: was that another"
                                + " vehicle");
    }
}
