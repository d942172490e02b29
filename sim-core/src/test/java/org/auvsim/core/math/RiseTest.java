package org.auvsim.core.math;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class RiseTest {
    @Test
    void risesFromNothingToAllAboutItsMiddle() {
        assertThat(Rise.share(1.8, 2, 0.4)).isZero();
        assertThat(Rise.share(2, 2, 0.4)).isCloseTo(0.5, within(1e-15));
        assertThat(Rise.share(2.2, 2, 0.4)).isCloseTo(1, within(1e-15));
        assertThat(Rise.share(9, 2, 0.4)).isEqualTo(1);
        assertThat(Rise.share(1.99, 2, 0)).isZero();
        assertThat(Rise.share(2, 2, 0)).isEqualTo(1);
    }

    @ParameterizedTest
    @ValueSource(doubles = {1.7, 1.83, 1.9, 2, 2.05, 2.19, 2.3})
    void theSlopeIsTheDerivative(double time) {
        double h = 1e-6;
        double difference = Rise.share(time + h, 2, 0.4) - Rise.share(time - h, 2, 0.4);
        assertThat(Rise.slope(time, 2, 0.4)).isCloseTo(difference / (2 * h), within(1e-8));
    }
}
