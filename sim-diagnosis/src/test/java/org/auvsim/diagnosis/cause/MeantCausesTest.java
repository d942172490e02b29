package org.auvsim.diagnosis.cause;

import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.auvsim.diagnosis.model.BelievedModel;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import java.util.List;

/** A cause of a part that the body does not have: the parts that it has are told. */
class MeantCausesTest {
    private static final BelievedModel VEHICLE = Tank.vehicle();

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            quoteCharacter = '"',
            value = {
                "thruster_gain (letf)|'thruster_gain (port)' or 'thruster_gain (starboard)'",
                "thruster_loss (letf)|'thruster_loss (port)' or 'thruster_loss (starboard)'",
                "thruster_gain (prot)|'thruster_gain (port)'",
                "thruster_misalignment (left)"
                        + "|'thruster_misalignment (port)' or 'thruster_misalignment (starboard)'",
                "thruster_gian (port)|'thruster_gain (port)'"
            })
    void thosePartsAreTold(String name, String meant) {
        assertThatThrownBy(() -> Library.requireKnown(List.of(name), VEHICLE))
                .hasMessageContaining(
                        " is known of '%s'; did you mean %s? docs/causes.md has all"
                                .formatted(VEHICLE.body(), meant));
    }
}
