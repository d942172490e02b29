package org.auvsim.diagnosis.verdict;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.diagnosis.cause.Quantity;
import org.auvsim.diagnosis.result.Finding;
import org.junit.jupiter.api.Test;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

class FeetTest {
    private static Optional<String> notice(String cause, double... factors) {
        List<Quantity> scales = new ArrayList<>();
        List<Double> deviations = new ArrayList<>();
        for (double factor : factors) {
            scales.add(new Quantity("scale", "1", factor));
            deviations.add(0.005);
        }
        return Feet.notice(
                List.of(new Finding(cause, Optional.empty(), scales, deviations, 1, false)));
    }

    @Test
    void anAxisMayBeInFeet() {
        assertThat(notice("sensor_scale", 1, 3.274, 1.002))
                .contains(
                        "y was found to be told 3.274 times as large as it is, and a metre is 3.281"
                                + " feet: is that in feet? If so, map it with a scale of 0.3048"
                                + " (--mapping)");
        assertThat(notice("sensor_scale", 3.281, 3.28, 3.279))
                .get()
                .asString()
                .startsWith("x, y, z were each");
    }

    @Test
    void otherScalesAreOfNoUnit() {
        assertThat(notice("sensor_scale", 1, 3.2, 0.98)).isEmpty();
        assertThat(notice("mass_error", 3.28)).isEmpty();
    }
}
