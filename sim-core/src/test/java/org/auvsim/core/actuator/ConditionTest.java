package org.auvsim.core.actuator;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;
import static org.auvsim.core.actuator.Screws.MASS;
import static org.auvsim.core.actuator.Screws.THRUST;
import static org.auvsim.core.actuator.Screws.advance;
import static org.auvsim.core.actuator.Screws.body;

import org.auvsim.core.world.World;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import java.util.List;
import java.util.Optional;

class ConditionTest {
    private static Condition failing(double from, double left) {
        return Condition.SOUND.failing(new Failure(from, left, 0.1));
    }

    @Test
    void aWornScrewGivesAShareOfItsThrust() {
        World world = Screws.world(Screws.plain(0.5).in(Condition.SOUND.gaining(0.8)));

        advance(world, 20);

        double expected = 0.8 * 0.5 * THRUST / MASS * world.time();
        assertThat(body(world).velocity().x()).isCloseTo(expected, within(1e-12));
    }

    /** It bites less astern: wired backwards that is what it does when it is told to go ahead. */
    @ParameterizedTest
    @CsvSource({"1, -4", "0.5, -2", "-0.5, 6", "-1, 12"})
    void aScrewThatIsWiredBackwardsTurnsToTheOtherSide(double commanded, double thrust) {
        ThrustTable biting =
                new ThrustTable(
                        List.of(
                                new ThrustTable.ThrustPoint(-1, -4),
                                new ThrustTable.ThrustPoint(0, 0),
                                new ThrustTable.ThrustPoint(1, 12)));
        Propulsor screw = Screws.lagging(commanded, 0, Optional.of(biting));
        Condition backwards = Condition.SOUND.gaining(-1);

        assertThat(screw.in(backwards).thrustAt(0)).isCloseTo(thrust, within(1e-12));
        assertThat(screw.in(Condition.SOUND.gaining(-0.5)).thrustAt(0))
                .isCloseTo(0.5 * thrust, within(1e-12));
    }

    @Test
    void theWorldFeelsTheScrewThatRunsBackwards() {
        World ahead = Screws.world(Screws.plain(-0.5));
        World backwards = Screws.world(Screws.plain(0.5).in(Condition.SOUND.gaining(-1)));

        advance(ahead, 20);
        advance(backwards, 20);

        assertThat(body(backwards).velocity()).isEqualTo(body(ahead).velocity());
    }

    /** Astern is where the screw turns to, whichever way it is wired. */
    @ParameterizedTest
    @CsvSource({"0.5, 1, 6", "-0.5, 1, -4.2", "0.5, -1, -4.2", "-0.5, -1, 6"})
    void aScrewMayPushLessAstern(double commanded, double gain, double thrust) {
        Condition condition = Condition.SOUND.gaining(gain).pushingAstern(0.7);
        Propulsor screw = Screws.plain(commanded).in(condition);
        assertThat(screw.thrustAt(3)).isCloseTo(thrust, within(1e-14));
        assertThat(screw.constantPush().orElseThrow().force().x()).isCloseTo(thrust, within(1e-14));
    }

    @ParameterizedTest
    @CsvSource({"0.5, 0.3", "-0.5, -0.3", "0.2, 0", "-0.1, 0", "1, 0.8"})
    void someOfTheLevelIsLost(double commanded, double left) {
        Propulsor screw = Screws.plain(commanded).in(Condition.SOUND.losing(0.2));
        assertThat(screw.levelAt(7)).isCloseTo(left, within(1e-15));
    }

    /** The velocity gained is that of a thrust which jumps at the middle of its fading. */
    @Test
    void aFailureTakesThrustFromItsTimeOn() {
        World world = Screws.world(Screws.plain(1).in(failing(0.52, 0.25)));

        advance(world, 40);

        double expected = THRUST / MASS * (0.52 + 0.25 * (world.time() - 0.52));
        assertThat(body(world).velocity().x()).isCloseTo(expected, within(1e-12));
        assertThat(Screws.screw(world).thrustAt(0.4)).isEqualTo(THRUST);
        assertThat(Screws.screw(world).thrustAt(0.6)).isEqualTo(0.25 * THRUST);
    }

    /** m dv/dt = T (1 - fade (t - from)), until nothing is left. */
    @ParameterizedTest
    @CsvSource({"0.4, 0.2", "0.4, 1", "0.4, -0.5"})
    void aSagTakesMoreAndMore(double from, double fade) {
        World world =
                Screws.world(Screws.plain(1).in(Condition.SOUND.sagging(new Sag(from, fade))));

        advance(world, 60);

        double falling = fade > 0 ? Math.min(world.time() - from, 1 / fade) : world.time() - from;
        double expected = THRUST / MASS * (from + falling - fade * falling * falling / 2);
        assertThat(body(world).velocity().x()).isCloseTo(expected, within(1e-9));
        assertThat(Screws.screw(world).thrustAt(from)).isEqualTo(THRUST);
    }

    @Test
    void whatIsOutOfRangeIsRefused() {
        assertThatIllegalArgumentException()
                .isThrownBy(() -> Condition.SOUND.gaining(Double.NaN))
                .withMessageContaining("the gain of the condition of a propulsor must be finite");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> Condition.SOUND.losing(1))
                .withMessageContaining("the lost level of the condition of a propulsor must be 0");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new Failure(1, -0.5, 0))
                .withMessageContaining("the share left of the failure of a propulsor must be 0");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new Sag(0, Double.NaN))
                .withMessageContaining("the fade of the sag of a propulsor must be finite");
    }
}
