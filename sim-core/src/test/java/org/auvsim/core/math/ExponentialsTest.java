package org.auvsim.core.math;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class ExponentialsTest {
    @Test
    void whatIsRememberedIsWhatIsComputed() {
        Exponentials known = new Exponentials();
        for (int round = 0; round < 3; round++) {
            for (int i = 0; i < 2000; i++) {
                double x = -0.013 * i;
                assertThat(known.exp(x)).isEqualTo(StrictMath.exp(x));
                assertThat(known.exp(x)).isEqualTo(StrictMath.exp(x));
            }
        }
    }

    @Test
    void nothingIsTakenForSomethingElse() {
        Exponentials known = new Exponentials();
        assertThat(known.exp(0)).isEqualTo(1);
        assertThat(known.exp(-0.0)).isEqualTo(1);
        assertThat(known.exp(Double.NaN)).isNaN();
        assertThat(known.exp(Double.NEGATIVE_INFINITY)).isZero();
        assertThat(known.exp(0)).isEqualTo(1);
    }
}
