package org.auvsim.experiments.thesis;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

import java.util.Arrays;

class PolynomialFitTest {
    private static final double[] X = {10, 20, 30, 40, 50, 60};

    @Test
    void recoversAPolynomial() {
        double[] y = Arrays.stream(X).map(x -> 7 - 3 * x + 0.5 * x * x).toArray();

        PolynomialFit fit = PolynomialFit.of(X, y, 2);

        assertThat(fit.coefficients().get(0)).isCloseTo(7, within(1e-9));
        assertThat(fit.coefficients().get(1)).isCloseTo(-3, within(1e-9));
        assertThat(fit.leading()).isCloseTo(0.5, within(1e-11));
        assertThat(fit.at(100)).isCloseTo(4707, within(1e-6));
        assertThat(fit.rSquared()).isCloseTo(1, within(1e-12));
    }

    /** Points 1, 2, 4 at 0, 1, 2: line 5/6 + 3/2 x, residuals 1/6, -1/3, 1/6, R^2 = 27/28. */
    @Test
    void saysHowMuchALineExplains() {
        PolynomialFit fit = PolynomialFit.of(new double[] {0, 1, 2}, new double[] {1, 2, 4}, 1);

        assertThat(fit.coefficients().get(0)).isCloseTo(5.0 / 6, within(1e-12));
        assertThat(fit.leading()).isCloseTo(1.5, within(1e-12));
        assertThat(fit.rSquared()).isCloseTo(27.0 / 28, within(1e-12));
    }

    @Test
    void tooFewPointsAreRefused() {
        assertThatIllegalArgumentException()
                .isThrownBy(() -> PolynomialFit.of(new double[3], new double[3], 2))
                .withMessage(
                        "a polynomial of degree 2 needs 4 or more points, but has 3 and 3 numbers");
    }
}
