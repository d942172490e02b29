package org.auvsim.diagnosis;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.auvsim.diagnosis.result.Diagnosis;
import org.auvsim.diagnosis.result.Finding;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.util.Set;

/**
 * A drag along x alone. Noise makes the drags along y and z, which are 0, negative in three of four
 * cases, which is no reason to refuse that along x.
 */
@Tag("whole-search")
class DragOfOneAxisTest {
    private static final double DRAG = 20;

    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3})
    void isFound(long seed) {
        PushedSphere sphere =
                new PushedSphere((p, v) -> new double[] {-DRAG * Math.abs(v[0]) * v[0], 0, 0});

        Diagnosis diagnosis =
                sphere.investigation(
                                seed, Set.of("linear_drag", "quadratic_drag", "anisotropic_drag"))
                        .diagnose();

        assertThat(diagnosis.selected())
                .extracting(Finding::cause)
                .containsExactly("anisotropic_drag");
        Finding drag = diagnosis.selected().getFirst();
        assertThat(drag.quantities().getFirst().value()).isCloseTo(DRAG, within(1.0));
    }

    /** A wrong number among those of a damping, as one and two specific causes do not have it. */
    @Test
    void ofALinearDragTheAxisIsFoundToo() {
        PushedSphere sphere = new PushedSphere((_, v) -> new double[] {-DRAG * v[0], 0, 0});

        Diagnosis diagnosis =
                sphere.investigation(
                                1,
                                Set.of(
                                        "linear_drag",
                                        "anisotropic_drag",
                                        "anisotropic_linear_drag"))
                        .diagnose();

        assertThat(diagnosis.selected())
                .extracting(Finding::cause)
                .containsExactly("anisotropic_linear_drag");
        Finding drag = diagnosis.selected().getFirst();
        assertThat(drag.quantities().getFirst().value()).isCloseTo(DRAG, within(0.5));
        assertThat(drag.quantities().get(1).value()).isCloseTo(0, within(0.5));
    }
}
