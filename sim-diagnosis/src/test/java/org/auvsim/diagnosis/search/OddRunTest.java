package org.auvsim.diagnosis.search;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.core.math.Vec3;
import org.auvsim.diagnosis.fit.Judged;
import org.auvsim.diagnosis.residual.Noise;
import org.auvsim.diagnosis.result.Diagnosis;
import org.auvsim.diagnosis.result.Verdict;
import org.auvsim.diagnosis.run.Channel;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.subject.AsBelieved;
import org.auvsim.diagnosis.subject.Believed;
import org.auvsim.diagnosis.subject.Surveyor;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

import java.util.List;
import java.util.Random;

/** Runs of a vehicle that is as believed, and one of another that differs from it in two ways. */
class OddRunTest {
    private static final MeasuredRun FIRST = sound(1);
    private static final MeasuredRun OTHER =
            new Surveyor(12, Vec3.ZERO, 0.7, 0).run("other", new Random(2));
    private static final MeasuredRun THIRD = sound(3);
    private static final MeasuredRun LAST = sound(4);

    private static MeasuredRun sound(int seed) {
        return new Surveyor(0, Vec3.ZERO, 1, 0).run("run" + seed, new Random(seed));
    }

    private static Judged believed(MeasuredRun... runs) throws Exception {
        Noise noise = Noise.of(List.of(FIRST, OTHER, THIRD, LAST));
        return AsBelieved.fitted(Surveyor.believed(), List.of(runs), noise);
    }

    @Test
    void aFittedRunThatAloneIsMissedIsTold() throws Exception {
        assertThat(OddRun.notice(believed(FIRST, OTHER, THIRD), believed(LAST)))
                .hasValueSatisfying(
                        said ->
                                assertThat(said)
                                        .startsWith(
                                                "the model as it is predicts run1, run3, run4 to"
                                                    + " the noise, and misses other alone: was that"
                                                    + " another vehicle"));
    }

    @Test
    void soIsAHeldOutOne() throws Exception {
        assertThat(OddRun.notice(believed(FIRST, THIRD), believed(OTHER)))
                .hasValueSatisfying(said -> assertThat(said).contains("misses other alone"));
    }

    /** A file that was given those of another. */
    @Test
    void commandsOfAnotherRunAreTold() throws Exception {
        MeasuredRun other = sound(9);
        MeasuredRun mixed =
                Surveyor.told(
                        new Surveyor(0, Vec3.ZERO, 1, 0).run("mixed", new Random(3)),
                        k -> other.vector(Channel.POSITION, k).orElseThrow(),
                        k -> other.orientation(k).orElseThrow());

        assertThat(OddRun.notice(believed(FIRST, mixed, THIRD), believed(LAST)))
                .hasValueSatisfying(
                        said ->
                                assertThat(said)
                                        .endsWith(
                                                "misses mixed alone: its commands are, row by row,"
                                                    + " those of run3 alone; are they its own?"));
    }

    @Test
    void whereMoreAreMissedOrFewPredictedNobodyKnowsWhichIsOdd() throws Exception {
        assertThat(OddRun.notice(believed(FIRST, OTHER), believed(OTHER))).isEmpty();
        assertThat(OddRun.notice(believed(FIRST), believed(OTHER))).isEmpty();
        assertThat(OddRun.notice(believed(FIRST, THIRD), believed(LAST))).isEmpty();
    }

    @Tag("whole-search")
    @Test
    void aDiagnosisThatExplainsNothingTellsIt() throws Exception {
        Diagnosis diagnosis =
                Believed.suspectedOf(
                        List.of("rotational_drag"),
                        Surveyor.believed(),
                        List.of(FIRST, OTHER, THIRD),
                        List.of(LAST));

        assertThat(diagnosis.verdict()).isEqualTo(Verdict.UNEXPLAINED);
        assertThat(diagnosis.notices())
                .filteredOn(notice -> notice.contains("misses other alone"))
                .hasSize(1);
    }
}
