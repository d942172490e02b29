package org.auvsim.diagnosis.fit;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.diagnosis.cause.Quantity;
import org.junit.jupiter.api.Test;

/** What two causes that explain the same have in common, in words. */
class AlternativesTest {
    private static final Quantity FORCE = new Quantity("constant_force x", "N", 12);
    private static final Quantity DRAG = new Quantity("quadratic_drag k", "kg/m", 0.0135);
    private static final Quantity MASS = new Quantity("mass_error factor", "1", 1.4);

    @Test
    void twoForcesShareTheirSum() {
        assertThat(Alternatives.relation(FORCE, new Quantity("buoyancy_error z", "N", 3)))
                .isEqualTo("constant_force x + 4.00 buoyancy_error z = 12.0 N");
    }

    @Test
    void whatActsTheOtherWayIsTakenAway() {
        assertThat(Alternatives.relation(FORCE, new Quantity("buoyancy_error z", "N", -3)))
                .isEqualTo("constant_force x - 4.00 buoyancy_error z = 12.0 N");
    }

    @Test
    void aFactorCountsFromOneSoThatEitherAloneFulfilsIt() {
        assertThat(Alternatives.relation(DRAG, MASS))
                .isEqualTo("quadratic_drag k + 0.0338 (mass_error factor - 1) = 0.0135 kg/m");
        assertThat(Alternatives.relation(MASS, DRAG))
                .isEqualTo("(mass_error factor - 1) + 29.6 quadratic_drag k = 0.400");
    }

    @Test
    void factorsThatUndoEachOtherShareTheirRatio() {
        assertThat(Alternatives.relation(MASS, new Quantity("thrust factor", "1", 0.71)))
                .isEqualTo("mass_error factor / thrust factor = 1.40");
    }

    @Test
    void factorsThatDoTheSameShareTheirProduct() {
        assertThat(Alternatives.relation(MASS, new Quantity("thrust factor", "1", 1.41)))
                .isEqualTo("mass_error factor * thrust factor = 1.40");
    }

    @Test
    void factorsOfUnlikeStrengthAreWeighed() {
        assertThat(Alternatives.relation(MASS, new Quantity("thrust factor", "1", 1.2)))
                .isEqualTo("(mass_error factor - 1) + 2.00 (thrust factor - 1) = 0.400");
    }
}
