package org.auvsim.diagnosis.fit;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

import java.util.List;

/** Products of columns. */
class GramTest {
    private static final Cart CART = new Cart(0.8, 2, 0.1);

    @Test
    void thoseOfSomeAreToTheBitThoseAmongAll() throws Exception {
        Hypothesis both =
                new Hypothesis(
                        List.of(CART.cause("linear_drag"), CART.cause("thruster_gain")),
                        List.of(new double[] {1}, new double[] {-0.1}));
        Fit fit = CART.fit(both);
        List<List<WindowBlock>> blocks = fit.blocks(fit.derivatives(), 2);

        Gram all = Gram.of(blocks, 2);
        Gram one = Gram.of(blocks, new int[] {1}, 2);
        Gram exchanged = Gram.of(blocks, new int[] {1, 0}, 2);

        assertThat(one.columns()).isEqualTo(1);
        assertThat(one.product(0, 0)).isEqualTo(all.product(1, 1));
        assertThat(one.cost()).isEqualTo(all.cost());
        assertThat(one.solve(new int[] {0})).isEqualTo(all.solve(new int[] {1}));
        assertThat(exchanged.solve(new int[] {0, 1})).isEqualTo(all.solve(new int[] {1, 0}));
    }
}
