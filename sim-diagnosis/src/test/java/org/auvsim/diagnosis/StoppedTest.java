package org.auvsim.diagnosis;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.diagnosis.fit.Progress;
import org.auvsim.diagnosis.result.Diagnosis;
import org.auvsim.diagnosis.result.Verdict;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.util.Set;

class StoppedTest {
    private static Diagnosis diagnosed(Progress progress) {
        Investigation whole =
                new PushedSphere((_, v) -> new double[] {-8 * v[0], -8 * v[1], -8 * v[2]})
                        .investigation(1, Set.of("linear_drag", "mass_error"));
        return new Investigation(
                        whole.model(), whole.fit(), whole.heldOut(), whole.causes(), 1, progress)
                .diagnose();
    }

    @Test
    void whatIsStoppedAtOnceSaysNothing() {
        Diagnosis diagnosis = diagnosed((stage, share) -> false);

        assertThat(diagnosis.isComplete()).isFalse();
        assertThat(diagnosis.verdict()).isEqualTo(Verdict.UNDECIDED);
        assertThat(diagnosis.sentence()).startsWith("Stopped before any cause was fitted: ");
        assertThat(diagnosis.evidence().ranked()).allMatch(set -> set.causes().isEmpty());
    }

    @ParameterizedTest
    @ValueSource(doubles = {0.5, 0.85})
    void whatIsStoppedClaimsNothingOfWhatWasNotTried(double end) {
        Diagnosis diagnosis = diagnosed((stage, share) -> share < end);

        assertThat(diagnosis.isComplete()).isFalse();
        assertThat(diagnosis.verdict()).isNotEqualTo(Verdict.UNDECIDED);
        assertThat(diagnosis.evidence().ranked()).anyMatch(set -> !set.causes().isEmpty());
        assertThat(diagnosis.sentence())
                .startsWith("Stopped before the end; the best so far: ")
                .doesNotContain("no known cause explains")
                .doesNotContain("shows nothing missing");
    }
}
