package org.auvsim.experiments.hidden;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** The plain way is no straw man: where there is hardly any noise it finds drag. */
class SparseRegressionTest {
    @ParameterizedTest(name = "seed {0}, a ball in air with drag")
    @ValueSource(longs = 55)
    void dragIsFoundWithoutNoise(long seed) {
        HiddenCase of = CaseBook.draw(CaseKind.SINGLE, 1e-6, seed);
        assertThat(of.body()).isEqualTo("ball in air");
        assertThat(of.hidden()).extracting(HiddenEffect::cause).containsExactly("quadratic_drag");

        assertThat(SparseRegression.causes(of))
                .as(of.toString())
                .contains("quadratic_drag")
                .hasSizeLessThan(4);
    }
}
