package org.auvsim.diagnosis;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.diagnosis.result.Diagnosis;
import org.junit.jupiter.api.Test;

import java.util.Set;

class StoppedTest {
    @Test
    void whatIsStoppedClaimsNothingOfWhatWasNotTried() {
        Investigation whole =
                new PushedSphere((_, v) -> new double[] {-8 * v[0], -8 * v[1], -8 * v[2]})
                        .investigation(1, Set.of("linear_drag", "mass_error"));
        Investigation stopped =
                new Investigation(
                        whole.model(),
                        whole.fit(),
                        whole.heldOut(),
                        whole.causes(),
                        1,
                        (stage, share) -> false);

        Diagnosis diagnosis = stopped.diagnose();

        assertThat(diagnosis.isComplete()).isFalse();
        assertThat(diagnosis.sentence())
                .startsWith("Stopped before the end; the best so far: ")
                .doesNotContain("no known cause explains")
                .doesNotContain("that this data could show");
    }
}
