package org.auvsim.experiments.hidden;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

import java.util.stream.LongStream;

/** The plain way is no straw man: where there is hardly any noise it finds drag. */
class SparseRegressionTest {
    @Test
    void dragIsFoundWithoutNoise() {
        HiddenCase of =
                LongStream.range(0, 500)
                        .mapToObj(seed -> CaseBook.draw(CaseKind.SINGLE, 1e-6, seed))
                        .filter(c -> c.body().equals("ball in air"))
                        .filter(c -> c.hidden().getFirst().cause().equals("quadratic_drag"))
                        .findFirst()
                        .orElseThrow();

        assertThat(SparseRegression.causes(of))
                .as(of.toString())
                .contains("quadratic_drag")
                .hasSizeLessThan(4);
    }
}
