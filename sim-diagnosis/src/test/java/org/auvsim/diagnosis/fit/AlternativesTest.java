package org.auvsim.diagnosis.fit;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.diagnosis.cause.Cause;
import org.auvsim.diagnosis.cause.Library;
import org.auvsim.diagnosis.cause.Quantity;
import org.auvsim.diagnosis.model.BelievedModel;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.junit.jupiter.api.Test;

import java.util.List;

/** What two causes that explain the same have in common, in words. */
class AlternativesTest {
    private static final Amount FORCE = amount("constant_force x", "N", 12, 0);
    private static final Amount DRAG = amount("quadratic_drag k", "kg/m", 0.0135, 0);
    private static final Amount MASS = amount("mass_error factor", "1", 1.4, 1);

    private static Amount amount(String name, String unit, double value, double neutral) {
        return new Amount(new Quantity(name, unit, value), neutral);
    }

    @Test
    void twoForcesShareTheirSum() {
        assertThat(Alternatives.relation(FORCE, amount("buoyancy_error z", "N", 3, 0)))
                .isEqualTo("constant_force x + 4.00 buoyancy_error z = 12.0 N");
    }

    @Test
    void whatActsTheOtherWayIsTakenAway() {
        assertThat(Alternatives.relation(FORCE, amount("buoyancy_error z", "N", -3, 0)))
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
        assertThat(Alternatives.relation(MASS, amount("thrust factor", "1", 0.71, 1)))
                .isEqualTo("mass_error factor / thrust factor = 1.40");
    }

    @Test
    void factorsThatDoTheSameShareTheirProduct() {
        assertThat(Alternatives.relation(MASS, amount("thrust factor", "1", 1.41, 1)))
                .isEqualTo("mass_error factor * thrust factor = 1.40");
    }

    @Test
    void factorsOfUnlikeStrengthAreWeighed() {
        assertThat(Alternatives.relation(MASS, amount("thrust factor", "1", 1.2, 1)))
                .isEqualTo("(mass_error factor - 1) + 2.00 (thrust factor - 1) = 0.400");
    }

    /** A ball of which the model has a restitution of 0.5 and a friction of 0.3. */
    @Test
    void whatTheModelHasOfANumberIsNoShareOfIt() throws Exception {
        BelievedModel model =
                Believed.model(
                        """
                        <scenario><time-step delta="0.1"/>
                          <world-object name="floor" fixed="1"><half-space/></world-object>
                          <world-object name="ball" mass="1" restitution="0.5" friction="0.3">
                            <position x="0" y="0" z="1"/><sphere radius="0.1"/><gravity/>
                          </world-object>
                        </scenario>
                        """,
                        "ball");
        Amount restitution = amount(model, "restitution", 0.2);
        Amount friction = amount(model, "contact_friction", -0.1);

        assertThat(Alternatives.relation(restitution, friction))
                .isEqualTo("(restitution e - 0.500) - 2.00 (contact_friction mu - 0.300) = 0.200");
        assertThat(Alternatives.relation(DRAG, restitution))
                .isEqualTo("quadratic_drag k + 0.0675 (restitution e - 0.500) = 0.0135 kg/m");
    }

    private static Amount amount(BelievedModel model, String id, double theta) {
        MeasuredRun run =
                MeasuredRun.named("run").at(0).position(0, 0, 1).at(1).position(0, 0, 0.5).build();
        List<Cause> library = Library.of(model, List.of(run));
        return Amount.of(Library.named(List.of(id), library).getFirst(), new double[] {theta}, 0);
    }
}
