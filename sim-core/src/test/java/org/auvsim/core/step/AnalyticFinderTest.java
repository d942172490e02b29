package org.auvsim.core.step;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import org.auvsim.core.actuator.Propulsor;
import org.auvsim.core.effect.Damping;
import org.auvsim.core.effect.Gravity;
import org.auvsim.core.entity.Frame;
import org.auvsim.core.entity.NamedForce;
import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.core.math.Draws;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.volume.Box;
import org.auvsim.core.world.World;
import org.auvsim.core.world.WorldBuilder;
import org.auvsim.core.world.WorldEvent;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

import java.util.stream.LongStream;
import java.util.stream.Stream;

class AnalyticFinderTest {
    private static double find(double dt, WorldObjectDefinition... objects) {
        return find(new AnalyticFinder(), dt, objects);
    }

    private static double find(CollisionFinder finder, double dt, WorldObjectDefinition... all) {
        Motion motion = Scene.of(all);
        return finder.earliest(motion, Scene.partition(motion, new AllPairsPartitioner(), dt), dt);
    }

    private static WorldObjectDefinition.Builder ball(String name) {
        return Scene.ball(name, 0.5);
    }

    private static NamedForce push(double x, double y, double z) {
        return NamedForce.direct("Push", Frame.WORLD, new Vec3(x, y, z));
    }

    @Test
    void headOn() {
        double met =
                find(
                        10,
                        ball("A").velocity(2, 0, 0).build(),
                        ball("B").position(7, 0, 0).velocity(-1, 0, 0).build());

        assertThat(met).isEqualTo(2, within(1e-14));
    }

    @Test
    void figureFiveOneInOneStep() {
        double met =
                find(
                        1,
                        ball("A").position(-1, 0, 0).velocity(2, 0, 0).build(),
                        ball("B").position(0, -1, 0).velocity(0, 2, 0).build());

        assertThat(met).isEqualTo((1 - 1 / Math.sqrt(2)) / 2, within(1e-15));
    }

    @Test
    void aBallThrownStraightUpAtAnotherThatStands() {
        // Gap 3 m; 8 t - 2 t^2 = 3 where the weight is 4 N.
        double met =
                find(
                        1,
                        ball("Thrown").velocity(0, 0, 8).force(push(0, 0, -4)).build(),
                        ball("Ceiling").position(0, 0, 4).fixed().build());

        assertThat(met).isEqualTo(2 - Math.sqrt(2.5), within(1e-14));
    }

    @Test
    void aBallThrownOverAWallOfOneBallComesDownOnTheNext() {
        World world =
                gravity(
                                ball("Thrown").velocity(3, 0, 4.5),
                                ball("Wall").position(0, 0, -2).fixed(),
                                ball("Target").position(3, 0, 0).fixed())
                        .build();
        double[] met = {0};
        world.addListener(
                event -> {
                    if (event instanceof WorldEvent.Collided c) {
                        met[0] = c.collision().contact().time();
                    }
                });

        world.advanceTimestep(2);

        double fall = 4.905;
        double t = met[0];
        double x = 3 * t - 3;
        double z = 4.5 * t - fall * t * t;
        assertThat(t).isBetween(0.5, 1.0);
        assertThat(Math.hypot(x, z)).isEqualTo(1, within(1e-13));
        assertThat(world.time()).isEqualTo(t);
    }

    private static WorldBuilder gravity(WorldObjectDefinition.Builder... balls) {
        WorldBuilder world =
                World.builder()
                        .stepper(
                                new SnapshotStepper(
                                        new NoRestricter(),
                                        new AllPairsPartitioner(),
                                        new AnalyticFinder()));
        for (WorldObjectDefinition.Builder ball : balls) {
            world.add(ball.effect(new Gravity(9.81)).build());
        }
        return world;
    }

    static LongStream seeds() {
        return LongStream.rangeClosed(1, 200);
    }

    /** Paths whose contact is known beforehand: both are drawn backward from it. */
    @ParameterizedTest(name = "seed {0}")
    @MethodSource("seeds")
    void aContactDrawnBeforehandIsFoundAtItsInstant(long seed) {
        Draws draws = new Draws(seed);
        double contact = draws.number(0.1, 1.9);
        Vec3 normal = draws.direction();
        Vec3 speed = draws.vector(3);
        Vec3 approach = normal.times(-draws.number(2, 4)).plus(draws.vector(0.1));
        Vec3 force = draws.vector(0.5);
        Vec3 place = draws.vector(10);

        double met =
                find(
                        2,
                        backward("A", place.plus(normal), speed.plus(approach), force, contact),
                        backward("B", place, speed, Vec3.ZERO, contact));

        assertThat(met).isEqualTo(contact, within(1e-12));
    }

    /** A ball of 1 kg that is there with that velocity after {@code t} seconds of that force. */
    private static WorldObjectDefinition backward(
            String name, Vec3 there, Vec3 velocity, Vec3 force, double t) {
        Vec3 start = there.minus(velocity.times(t)).plus(force.times(t * t / 2));
        Vec3 before = velocity.minus(force.times(t));
        return ball(name)
                .position(start)
                .velocity(before.x(), before.y(), before.z())
                .force(push(force.x(), force.y(), force.z()))
                .build();
    }

    @ParameterizedTest(name = "depth {0} m")
    @MethodSource("depths")
    void aGrazingContactIsFoundThatBisectionMisses(double depth) {
        double aside = (1 - depth) / 2;
        WorldObjectDefinition[] passing = {
            ball("A").position(-2.3, aside, 0).velocity(5, 0, 0).build(),
            ball("B").position(2.3, -aside, 0).velocity(-5, 0, 0).build()
        };

        assertThat(find(BisectionFinder.standard(), 1, passing)).isInfinite();
        double half = Math.sqrt(depth * (2 - depth));
        assertThat(find(1, passing)).isEqualTo((4.6 - half) / 10, within(1e-15 / half + 1e-15));
        assertThat(find(1, ball("A").build(), ball("B").position(0, 1 + depth, 0).build()))
                .isInfinite();
    }

    static Stream<Double> depths() {
        return Stream.of(1e-2, 1e-4, 1e-8, 1e-12);
    }

    @Test
    void whatPassesJustOutsideIsLeftAlone() {
        WorldObjectDefinition[] passing = {
            ball("A").position(-2.3, 0.5 + 1e-12, 0).velocity(5, 0, 0).build(),
            ball("B").position(2.3, -0.5, 0).velocity(-5, 0, 0).build()
        };

        assertThat(find(1, passing)).isInfinite();
    }

    @Test
    void afterABounceTheSearchBeginsAgainWhenTheTwoAreApart() {
        // Distance 1 + 2 t - 2 t^2: they touch and part, and are back after 1 s.
        double met =
                find(
                        2,
                        ball("A").position(1, 0, 0).velocity(2, 0, 0).force(push(-4, 0, 0)).build(),
                        ball("B").fixed().build());

        assertThat(met).isEqualTo(1, within(1e-14));
    }

    @ParameterizedTest(name = "{0}")
    @MethodSource("others")
    void whatTheFormulaDoesNotCoverIsRefusedByName(String why, WorldObjectDefinition other) {
        assertThatThrownBy(() -> find(1, ball("A").build(), other))
                .isInstanceOf(StepException.class)
                .hasMessage(
                        "the analytic finder cannot follow 'Odd' (id 2) at 0.0 s: "
                                + why
                                + "; choose another finder, such as the bisection finder");
    }

    static Stream<Arguments> others() {
        WorldObjectDefinition.Builder spinning = odd().angularVelocity(0, 0, 1e-9);
        return Stream.of(
                Arguments.of("it turns", spinning.build()),
                Arguments.of(
                        "its force 'Engine' is fixed in body axes",
                        odd().force(NamedForce.direct("Engine", Frame.BODY, new Vec3(1, 0, 0)))
                                .build()),
                Arguments.of(
                        "its force 'Rope' makes it turn",
                        odd().force(
                                        new NamedForce(
                                                "Rope",
                                                Frame.WORLD,
                                                new Vec3(1, 0, 0),
                                                new Vec3(0, 0.5, 0)))
                                .build()),
                Arguments.of(
                        "its propulsor 'Screw' pushes in body axes",
                        odd().component(new Propulsor("Screw", 5, 1, Vec3.ZERO, new Vec3(1, 0, 0)))
                                .build()),
                Arguments.of(
                        "its volume is no sphere but a Box",
                        WorldObjectDefinition.named("Odd")
                                .fixed()
                                .position(0, 0, 9)
                                .volume(new Box(new Vec3(1, 1, 1)))
                                .build()));
    }

    private static WorldObjectDefinition.Builder odd() {
        return ball("Odd").position(5, 0, 0);
    }

    @Test
    void anEffectThatMakesTheAccelerationVaryIsNamed() {
        World world =
                gravity(
                                ball("Feather")
                                        .velocity(3, 0, 0)
                                        .effect(
                                                new Damping(
                                                        new Vec3(1, 1, 1),
                                                        Vec3.ZERO,
                                                        Vec3.ZERO,
                                                        Vec3.ZERO)))
                        .build();

        assertThatThrownBy(world::advanceTimestep)
                .isInstanceOf(StepException.class)
                .hasMessageContaining(
                        "'Feather' (id 1) at 0.0 s: its acceleration varies (effects on it:"
                                + " Damping, Gravity)");
        assertThat(world.time()).isZero();
    }

    @Test
    void anEngineThatStandsStillIsNoForceInBodyAxes() {
        Propulsor off = new Propulsor("Screw", 5, 0, Vec3.ZERO, new Vec3(1, 0, 0));

        assertThat(
                        find(
                                1,
                                ball("A").component(off).velocity(4, 0, 0).build(),
                                ball("B").position(3, 0, 0).build()))
                .isEqualTo(0.5, within(1e-15));
    }
}
