package org.auvsim.diagnosis.fit;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.diagnosis.cause.Cause;
import org.auvsim.diagnosis.subject.Cart;
import org.junit.jupiter.api.Test;

import java.util.List;

/** What the data does not determine is not made up. */
class UndeterminedTest {
    /** So little that there is none. */
    private static final Cart CART = new Cart(0.8, 1e-6, 0);

    @Test
    void aHeadingThatDoesNotShowStaysInAllWindows() throws Exception {
        Fit fit = CART.fit(Hypothesis.NONE);

        assertThat(fit.windows().getFirst())
                .hasSizeGreaterThan(4)
                .allSatisfy(
                        window ->
                                assertThat(window.start().orientation().w())
                                        .isGreaterThan(1 - 1e-6));
    }

    /** A body without drag does not feel the current: its columns are errors of rounding. */
    @Test
    void whatLeavesNoTraceIsNotMoved() throws Exception {
        Cause current = CART.cause("current_constant");
        Fit fit = CART.fit(new Hypothesis(List.of(current), List.of(new double[3])));

        Judged fitted = Descent.of(Refinement.approach(fit, 1)).steps(10);

        for (double u : fitted.fit().hypothesis().numbers()) {
            assertThat(u).isBetween(-1.0, 1.0);
        }
    }

    /** A light cart with a weak motor moves as a heavy one with a strong motor. */
    @Test
    void numbersOfWhichOnlyTheRatioShowsAreUncertain() throws Exception {
        Hypothesis both =
                new Hypothesis(
                        List.of(CART.cause("thruster_gain"), CART.cause("mass_error")),
                        List.of(new double[] {-0.1}, new double[] {0.125}));

        List<List<Double>> deviations =
                new Uncertainty(Judged.of(CART.fit(both).whole())).deviations();

        assertThat(deviations).allSatisfy(of -> assertThat(of.getFirst()).isGreaterThan(0.1));
    }
}
