package org.auvsim.diagnosis.cause;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.auvsim.diagnosis.model.BelievedModel;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import java.util.List;

/** Of a force nothing is looked for along an axis along which a body cannot go. */
class HeldForcesTest {
    private static final int MEASURED = 100;

    @ParameterizedTest
    @CsvSource({
        "step_force, '', 4",
        "step_force, '<held z=\"1\" turn-x=\"1\" turn-y=\"1\"/>', 3",
        "impulse, '<held y=\"1\" z=\"1\"/>', 2",
        "periodic_force, '', 7",
        "periodic_force, '<held z=\"1\" turn-x=\"1\" turn-y=\"1\"/>', 5",
        "periodic_force, '<held y=\"1\" z=\"1\"/>', 3",
        "periodic_force, '<pinned/>', 7",
    })
    void areNotPaidFor(String id, String mount, int free) {
        BelievedModel model = Tank.model("", mount);
        Cause cause =
                Library.of(model, List.of(Tank.run(model, 61))).stream()
                        .filter(of -> of.id().equals(id))
                        .findFirst()
                        .orElseThrow();

        assertThat(cause.price(MEASURED, MEASURED) - cause.price())
                .isCloseTo(free * StrictMath.log(MEASURED), within(1e-9));
    }
}
