package org.auvsim.diagnosis.search;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.diagnosis.cause.Cause;
import org.auvsim.diagnosis.cause.Library;
import org.auvsim.diagnosis.cause.Quantity;
import org.auvsim.diagnosis.model.BelievedModel;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.subject.Believed;
import org.auvsim.diagnosis.subject.Cart;
import org.junit.jupiter.api.Test;

import java.util.List;

/** What may be instead of each other, in words. */
class BarterTest {
    private static final Amount FORCE = amount("constant force x", "N", 12, 0);
    private static final Amount DRAG = amount("quadratic drag k", "kg/m", 0.0135, 0);
    private static final Amount MASS = amount("mass error factor", "1", 1.4, 1);

    private static Amount amount(String name, String unit, double value, double neutral) {
        return new Amount(new Quantity(name, unit, value), neutral);
    }

    @Test
    void ofWhatIsAddedTheSumIsTold() {
        assertThat(
                        Barter.words(
                                amount("sensor delay", "s", 0.7, 0),
                                amount("clock offset", "s", 0.701, 0)))
                .isEqualTo(
                        "a sensor delay of 0.700 s, or a clock offset of 0.701 s, or parts of both:"
                                + " only their sum is told");
    }

    @Test
    void ofWhatActsTheOtherWayTheDifferenceIsTold() {
        assertThat(Barter.words(FORCE, amount("buoyancy error z", "N", -12, 0)))
                .isEqualTo(
                        "a constant force x of 12.0 N, or a buoyancy error z of -12.0 N, or parts"
                                + " of both: only their difference is told");
    }

    @Test
    void ofWhatIsUnlikeAPartMayBeReplaced() {
        assertThat(Barter.words(FORCE, amount("buoyancy error z", "N", 3, 0)))
                .isEqualTo(
                        "a constant force x of 12.0 N, or a buoyancy error z of 3.00 N, or a part"
                                + " of the one and the rest of the other");
        assertThat(Barter.words(DRAG, MASS))
                .isEqualTo(
                        "a quadratic drag k of 0.0135 kg/m, or a mass error factor of 1.40, or a"
                                + " part of the one and the rest of the other");
    }

    @Test
    void factorsThatUndoEachOtherShareTheirRatio() {
        assertThat(Barter.words(MASS, amount("thrust factor", "1", 0.71, 1)))
                .isEqualTo(
                        "a mass error factor of 1.40, or a thrust factor of 0.710, or any two whose"
                                + " ratio is 1.40");
    }

    @Test
    void factorsThatDoTheSameShareTheirProduct() {
        assertThat(Barter.words(MASS, amount("thrust factor", "1", 1.41, 1)))
                .endsWith("or any two whose product is 1.40");
    }

    @Test
    void ofFactorsOfUnlikeStrengthAPartMayBeReplaced() {
        assertThat(Barter.words(MASS, amount("thrust factor", "1", 1.2, 1)))
                .endsWith("or a part of the one and the rest of the other");
    }

    /** "A factor of 1.00" would say that nothing is wrong. */
    @Test
    void aFactorShowsByHowMuchItDiffersFromOne() {
        assertThat(amount("mass error factor", "1", 0.9999, 1).words())
                .isEqualTo("a mass error factor of 0.99990");
        assertThat(amount("mass error factor", "1", 1.0004, 1).words())
                .isEqualTo("a mass error factor of 1.0004");
        assertThat(amount("mass error factor", "1", 1.02, 1).words())
                .isEqualTo("a mass error factor of 1.02");
        assertThat(amount("mass error factor", "1", 1, 1).words())
                .isEqualTo("a mass error factor of 1.00");
    }

    @Test
    void aNumberIsNamedOnce() throws Exception {
        BelievedModel model = Cart.believed();
        assertThat(amount(model, "clock_offset", -0.4).words())
                .isEqualTo("a clock offset of -0.400 s");
        Cause gain = new Cart(0.8, 0, 0).cause("thruster_gain");
        assertThat(Amount.of(gain, new double[] {-0.2}, 0).words())
                .isEqualTo("a thruster gain (motor) factor of 0.800");
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

        assertThat(Barter.words(restitution, friction))
                .isEqualTo(
                        "a restitution e of 0.700 instead of 0.500, or a contact friction mu of"
                                + " 0.200 instead of 0.300, or a part of the one and the rest of"
                                + " the other");
    }

    private static Amount amount(BelievedModel model, String id, double theta) {
        MeasuredRun run =
                MeasuredRun.named("run").at(0).position(0, 0, 1).at(1).position(0, 0, 0.5).build();
        List<Cause> library = Library.of(model, List.of(run));
        return Amount.of(Library.named(List.of(id), library).getFirst(), new double[] {theta}, 0);
    }
}
