package org.auvsim.diagnosis.fit;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.auvsim.diagnosis.subject.Cart;
import org.junit.jupiter.api.Test;

/** A cart that is slowed by drag alone, with a first place and a first speed that nobody knows. */
class StartsTest {
    private static final Cart CART = new Cart(1, 30, 0);
    private static final double MASS = 10;
    private static final double SPACING = 0.1;
    private static final int SAMPLES = 400;

    @Test
    void startsThatNeverFadeMustBeChosenFinely() throws Exception {
        double more = fineness(1) - fineness(30);

        assertThat(more).isCloseTo(information(1) - information(30), within(0.02));
        assertThat(more).isGreaterThan(5);
    }

    private static double fineness(double drag) throws Exception {
        return Starts.fineness(
                CART.fit(Hypothesis.NONE.and(CART.cause("linear_drag"), new double[] {drag})));
    }

    /** Logarithm of the determinant of what places tell of the start, up to a constant. */
    private static double information(double drag) {
        double sum = 0;
        double squares = 0;
        for (int k = 0; k < SAMPLES; k++) {
            double way = MASS / drag * (1 - Math.exp(-drag / MASS * k * SPACING)); // of 1 m/s
            sum += way;
            squares += way * way;
        }
        return Math.log(SAMPLES * squares - sum * sum);
    }
}
