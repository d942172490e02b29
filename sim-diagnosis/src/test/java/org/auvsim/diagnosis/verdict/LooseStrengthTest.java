package org.auvsim.diagnosis.verdict;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.diagnosis.cause.Quantity;
import org.auvsim.diagnosis.result.Finding;
import org.junit.jupiter.api.Test;

import java.util.List;
import java.util.Optional;

class LooseStrengthTest {
    private static Finding current(double x, double ofX, double y, double ofY, double ofOmega) {
        return new Finding(
                "current_oscillating",
                Optional.empty(),
                List.of(
                        new Quantity("u.x", "m/s", x),
                        new Quantity("u.y", "m/s", y),
                        new Quantity("omega", "rad/s", 0.24)),
                List.of(ofX, ofY, ofOmega),
                1,
                true);
    }

    /** As it was found where a force grew with the square of the place: 66 +- 84 m/s. */
    @Test
    void aStrengthWithinItsDeviationIsTold() {
        assertThat(LooseStrength.notices(List.of(current(66, 84, 31, 14, 0.12))))
                .singleElement()
                .asString()
                .startsWith("how strong current_oscillating is these runs do not tell (u.x 66")
                .contains("+- 84 m/s)");
    }

    /** A vector has a direction: across it there is nothing, give or take a little. */
    @Test
    void onlyTheLargestNumberOfAVectorCounts() {
        assertThat(LooseStrength.notices(List.of(current(66, 8, 0.1, 0.3, 0.12)))).isEmpty();
        assertThat(LooseStrength.notices(List.of(current(0.1, 0.3, -66, 8, 0.12)))).isEmpty();
    }

    @Test
    void whereAndWhenIsNoStrength() {
        assertThat(LooseStrength.notices(List.of(current(66, 8, 0.1, 0.3, 3)))).isEmpty();
    }

    @Test
    void whatHasNoDeviationsIsNotAsked() {
        Finding unsure =
                new Finding(
                        "quadratic_drag",
                        Optional.empty(),
                        List.of(new Quantity("k", "kg/m", 1e-3)),
                        List.of(),
                        1,
                        true);

        assertThat(LooseStrength.notices(List.of(unsure))).isEmpty();
    }
}
