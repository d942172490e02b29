package org.auvsim.diagnosis.verdict;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.core.math.Vec3;
import org.auvsim.diagnosis.result.Diagnosis;
import org.auvsim.diagnosis.result.Verdict;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.subject.Believed;
import org.auvsim.diagnosis.subject.Surveyor;
import org.junit.jupiter.api.Test;

import java.util.List;
import java.util.Random;

/** A vehicle whose runs no cause explains. */
class LikelyReasonTest {
    private static final Surveyor AS_BELIEVED = new Surveyor(0, Vec3.ZERO, 1, 0);

    private static MeasuredRun run(String name, int seed) {
        return AS_BELIEVED.run(name, new Random(seed)).swapping("starboard", "vertical");
    }

    private static Diagnosis diagnosis(MeasuredRun fit, MeasuredRun heldOut) throws Exception {
        return Believed.suspectedOf(
                "linear_drag", Surveyor.believed(), List.of(fit), List.of(heldOut));
    }

    @Test
    void commandsThatAreSwappedAreToldAndCastDoubt() throws Exception {
        Diagnosis diagnosis = diagnosis(run("fit", 4), run("held out", 5));

        assertThat(diagnosis.verdict()).isEqualTo(Verdict.UNEXPLAINED);
        assertThat(diagnosis.notices())
                .anySatisfy(said -> assertThat(said).contains("'starboard' are swapped"));
        assertThat(diagnosis.sentence()).contains("but the notices cast doubt on the data");
        assertThat(diagnosis.doubted().sentence()).isEqualTo(diagnosis.sentence());
    }

    @Test
    void whatTheModelLacksCastsNone() throws Exception {
        Surveyor carried = new Surveyor(0, new Vec3(0, 0.3, 0), 1, 0);
        Diagnosis diagnosis =
                diagnosis(
                        carried.run("fit", new Random(4)), carried.run("held out", new Random(5)));

        assertThat(diagnosis.verdict()).isEqualTo(Verdict.UNEXPLAINED);
        assertThat(diagnosis.sentence()).doesNotContain("doubt");
    }
}
