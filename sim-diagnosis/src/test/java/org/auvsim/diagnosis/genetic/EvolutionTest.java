package org.auvsim.diagnosis.genetic;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.auvsim.diagnosis.Method;
import org.auvsim.diagnosis.PushedSphere;
import org.auvsim.diagnosis.result.Diagnosis;
import org.auvsim.diagnosis.result.Finding;
import org.auvsim.diagnosis.result.Verdict;
import org.junit.jupiter.api.Test;

import java.util.Set;

/** Competing models find the drag of a pushed sphere, and find it again. */
class EvolutionTest {
    private static final double DRAG = 12;

    private static final PushedSphere SPHERE =
            new PushedSphere(
                    (_, v) -> {
                        double speed = Math.sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
                        return new double[] {
                            -DRAG * speed * v[0], -DRAG * speed * v[1], -DRAG * speed * v[2]
                        };
                    });

    /** What looks alike: the drag must win against them. */
    private static final Set<String> CAUSES =
            Set.of("linear_drag", "quadratic_drag", "anisotropic_drag");

    private static Diagnosis diagnosis(Set<String> causes) {
        return SPHERE.investigation(1, causes).by(Method.GENETIC).diagnose();
    }

    @Test
    void aDragIsFoundAndSoAgain() {
        Diagnosis diagnosis = diagnosis(CAUSES);

        assertThat(diagnosis.verdict()).as(diagnosis.sentence()).isEqualTo(Verdict.EXPLAINED);
        assertThat(diagnosis.selected())
                .extracting(Finding::cause)
                .containsExactly("quadratic_drag");
        assertThat(diagnosis.selected().getFirst().quantities().getFirst().value())
                .isCloseTo(DRAG, within(0.2));
        assertThat(diagnosis.conclusion().proposal()).isEmpty();
        assertThat(diagnosis(CAUSES).evidence().ranked()).isEqualTo(diagnosis.evidence().ranked());
    }

    /** As if only causes were chosen that this body cannot have. */
    @Test
    void ofNoCausesNoneIsFound() {
        Diagnosis diagnosis = diagnosis(Set.of());

        assertThat(diagnosis.verdict()).isEqualTo(Verdict.UNEXPLAINED);
        assertThat(diagnosis.selected()).isEmpty();
    }
}
