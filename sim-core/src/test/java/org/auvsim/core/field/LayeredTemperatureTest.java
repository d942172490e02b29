package org.auvsim.core.field;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;

import org.auvsim.core.math.Vec3;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class LayeredTemperatureTest {
    private static final LayeredTemperature BALTIC =
            new LayeredTemperature(1, "Baltic", 18, 0.05, 10, 20, 8, 0);

    /** Half of the drop at the thermocline's middle, (1 + tanh 1)/2 of it at its lower edge. */
    @CsvSource({"5, 18", "0, 18", "-20, 12", "-24, 7.992", "-60, 5"})
    @ParameterizedTest
    void isColderTheDeeperItIs(double z, double expected) {
        assertThat(BALTIC.valueAt(new Vec3(3, 4, z), 7)).isCloseTo(expected, within(1e-3));
    }

    @Test
    void aThermoclineHasAThickness() {
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new LayeredTemperature(1, "t", 18, 0, 1, 2, 0, 0))
                .withMessageContaining("the thickness of temperature field 't' must be above 0 m");
    }
}
