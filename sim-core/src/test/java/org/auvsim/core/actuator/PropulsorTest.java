package org.auvsim.core.actuator;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;
import static org.auvsim.core.actuator.Screws.LAG;
import static org.auvsim.core.actuator.Screws.MASS;
import static org.auvsim.core.actuator.Screws.THRUST;
import static org.auvsim.core.actuator.Screws.advance;
import static org.auvsim.core.actuator.Screws.body;
import static org.auvsim.core.actuator.Screws.lagging;
import static org.auvsim.core.actuator.Screws.screw;
import static org.auvsim.core.math.Near.assertNear;

import org.auvsim.core.effect.Damping;
import org.auvsim.core.entity.Inertia;
import org.auvsim.core.entity.WorldObject;
import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.core.math.Numbers;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.volume.Sphere;
import org.auvsim.core.world.World;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import java.util.List;
import java.util.Optional;

class PropulsorTest {
    @Test
    void quadraticDragAgainstAConstantThrustGivesAHyperbolicTangent() {
        double b = 3;
        World world =
                World.builder()
                        .timeStep(0.05)
                        .add(
                                WorldObjectDefinition.named("body")
                                        .mass(MASS)
                                        .volume(new Sphere(0.2))
                                        .effect(quadratic(b))
                                        .component(Screws.plain(0.75))
                                        .build())
                        .build();

        advance(world, 60);

        double terminal = Math.sqrt(0.75 * THRUST / b);
        double expected = terminal * Math.tanh(terminal * b / MASS * world.time());
        assertThat(body(world).velocity().x()).isCloseTo(expected, within(1e-6));
    }

    private static Damping quadratic(double b) {
        return new Damping(Vec3.ZERO, new Vec3(b, b, b), Vec3.ZERO, Vec3.ZERO);
    }

    @Test
    void aLaggingThrustGrowsExponentially() {
        World world = Screws.world(lagging(0, 0, Optional.empty()));
        body(world).command(Propulsor.class, "screw", 0.5);

        advance(world, 40);

        double t = world.time();
        double gained = 0.5 * THRUST / MASS * (t - LAG * (1 - Math.exp(-t / LAG)));
        assertThat(body(world).velocity().x()).isCloseTo(gained, within(1e-7));
        assertThat(screw(world).levelAt(t))
                .isCloseTo(0.5 * (1 - Math.exp(-t / LAG)), within(1e-15));
    }

    @Test
    void aCommandOnTheWayGoesOnFromTheLevelReached() {
        Propulsor first = lagging(0, 0, Optional.empty()).commanded(1, 2);
        Propulsor second = first.commanded(-0.5, 2.3);
        double reached = 1 - Math.exp(-0.3 / LAG);

        assertThat(second.levelAt(2.3)).isCloseTo(reached, within(1e-15));
        assertThat(second.levelAt(2.8))
                .isCloseTo(-0.5 + (reached + 0.5) * Math.exp(-0.5 / LAG), within(1e-15));
        assertThat(second.levelAt(100)).isEqualTo(-0.5);
    }

    @ParameterizedTest
    @CsvSource({"0, 0", "0.2, 0", "-0.2, 0", "0.6, 0.5", "-0.6, -0.5", "1, 1"})
    void withinTheDeadZoneNothingMovesAndBeyondItTheLevelGrowsToOne(double told, double level) {
        assertThat(lagging(told, 0.2, Optional.empty()).levelAt(0)).isCloseTo(level, within(1e-15));
    }

    @Test
    void aTableIsReadByStraightLinesAndSaturates() {
        ThrustCurve table =
                new ThrustTable(
                        List.of(
                                new ThrustTable.ThrustPoint(-0.9, -8),
                                new ThrustTable.ThrustPoint(0, 0),
                                new ThrustTable.ThrustPoint(0.5, 4),
                                new ThrustTable.ThrustPoint(1, 20)));

        assertThat(table.thrust(-1)).isEqualTo(-8);
        assertThat(table.thrust(-0.45)).isEqualTo(-4);
        assertThat(table.thrust(0.75)).isEqualTo(12);
        assertThat(lagging(1, 0, Optional.of(table)).thrustAt(0)).isEqualTo(THRUST);
        assertThat(lagging(0.5, 0, Optional.of(table)).thrustAt(0)).isEqualTo(4);
    }

    @Test
    void aPolynomialIsTheSameAheadAndAstern() {
        ThrustCurve curve = new PolynomialThrust(Numbers.of(2, 5, -1));

        assertThat(curve.thrust(0.5)).isEqualTo(2 * 0.5 + 5 * 0.25 - 0.125);
        assertThat(curve.thrust(-0.5)).isEqualTo(-curve.thrust(0.5));
        assertThat(curve.thrust(0)).isZero();
    }

    @Test
    void aTableOutOfOrderIsRefusedByItsRow() {
        List<ThrustTable.ThrustPoint> rows =
                List.of(
                        new ThrustTable.ThrustPoint(-1, -5),
                        new ThrustTable.ThrustPoint(0.5, 2),
                        new ThrustTable.ThrustPoint(0.4, 3));

        assertThatIllegalArgumentException()
                .isThrownBy(() -> new ThrustTable(rows))
                .withMessage(
                        "point 3 of a thrust table has level 0.4, which is not above the 0.5 of"
                                + " point 2; put them in order of level, each level once");
        assertThatIllegalArgumentException()
                .isThrownBy(
                        () ->
                                new ThrustTable(
                                        List.of(
                                                new ThrustTable.ThrustPoint(-1, -5),
                                                new ThrustTable.ThrustPoint(1, 6))))
                .withMessage("a thrust table must give 0 N at level 0, but gives 0.5 N");
    }

    /** What a settled propulsor with a lag adds in each stage is what one without adds up front. */
    @Test
    void forceAndTorqueAreTheSameByStageAndAsAConstant() {
        Vec3 place = new Vec3(-0.004, 0.003, 0.001);
        Vec3 towards = new Vec3(0.6, 0.1, -0.2);
        Propulsor atOnce = turning(place, towards, 0);
        Propulsor settled = turning(place, towards, 1e-9).commanded(0.8, -1);
        assertThat(atOnce.constantPush()).isPresent();
        assertThat(settled.constantPush()).isEmpty();
        World constant = Screws.world(atOnce);
        World byStage = Screws.world(settled);

        advance(constant, 40);
        advance(byStage, 40);

        WorldObject body = body(constant);
        assertThat(body.angularMomentum().norm()).isGreaterThan(0.01);
        assertNear(body(byStage).position(), body.position(), 1e-12);
        assertNear(body(byStage).angularMomentum(), body.angularMomentum(), 1e-12);
        double thrust = 0.8 * THRUST;
        Vec3 direction = towards.normalized();
        Vec3 torque = place.cross(direction.times(thrust)).plus(direction.times(-0.001 * thrust));
        assertNear(atOnce.constantPush().orElseThrow().torque(), torque, 1e-14);
    }

    private static Propulsor turning(Vec3 place, Vec3 towards, double lag) {
        return new Propulsor(
                "screw",
                THRUST,
                0.8,
                place,
                towards,
                Optional.empty(),
                lag,
                0,
                -0.001,
                0,
                Optional.empty(),
                Optional.empty(),
                Optional.empty(),
                Optional.empty());
    }

    /** The spin that a rotor gains is taken from the body, whichever way that turns meanwhile. */
    @Test
    void bodyAndRotorKeepTheirAngularMomentum() {
        Rotor rotor = new Rotor(0.002, 300);
        Propulsor wheel =
                new Propulsor(
                        "screw",
                        0,
                        0,
                        Vec3.ZERO,
                        new Vec3(0.6, 0, 0.8),
                        Optional.empty(),
                        LAG,
                        0,
                        0,
                        0,
                        Optional.of(rotor),
                        Optional.empty(),
                        Optional.empty(),
                        Optional.empty());
        World world =
                World.builder()
                        .timeStep(0.005)
                        .add(
                                WorldObjectDefinition.named("body")
                                        .mass(MASS)
                                        .volume(new Sphere(0.2))
                                        .inertia(new Inertia(0.3, 0.5, 0.4, 0, 0, 0))
                                        .angularVelocity(0.4, -0.3, 0.7)
                                        .component(wheel)
                                        .build())
                        .build();
        Vec3 before = body(world).angularMomentum();
        body(world).command(Propulsor.class, "screw", 1);

        advance(world, 400);

        double level = screw(world).levelAt(world.time());
        Vec3 axis = body(world).orientation().rotate(screw(world).direction());
        Vec3 spin = axis.times(0.002 * 300 * level);
        assertThat(spin.norm()).isGreaterThan(0.5);
        assertNear(body(world).angularMomentum().plus(spin), before, 1e-9);
    }

    @Test
    void aRotorWithoutALagIsRefused() {
        assertThatIllegalArgumentException()
                .isThrownBy(
                        () ->
                                new Propulsor(
                                        "screw",
                                        1,
                                        0,
                                        Vec3.ZERO,
                                        new Vec3(1, 0, 0),
                                        Optional.empty(),
                                        0,
                                        0,
                                        0,
                                        0,
                                        Optional.of(new Rotor(1, 1)),
                                        Optional.empty(),
                                        Optional.empty(),
                                        Optional.empty()))
                .withMessageContaining(
                        "propulsor 'screw' has a rotor and so needs a lag above 0 s");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> lagging(0, 1, Optional.empty()))
                .withMessage("the dead zone of propulsor 'screw' must be 0 to below 1, but is 1.0");
    }

    @Test
    void aCopyInTheMiddleOfALagGoesOnAlike() {
        World world = Screws.world(lagging(0, 0, Optional.empty()));
        body(world).command(Propulsor.class, "screw", 1);
        advance(world, 5);
        World copy = world.copy();
        World again =
                World.builder()
                        .timeStep(0.05)
                        .startTime(world.time())
                        .add(body(world).presentDefinition())
                        .build();

        for (World each : List.of(world, copy, again)) {
            body(each).command(Propulsor.class, "screw", -1);
            advance(each, 20);
        }

        assertThat(copy.stateHash()).isEqualTo(world.stateHash());
        assertNear(body(again).position(), body(world).position(), 1e-12);
        assertThat(body(world).components()).isEqualTo(body(copy).components());
    }
}
