package org.auvsim.core.step;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;
import static org.auvsim.core.math.Near.assertNear;

import org.auvsim.core.effect.Damping;
import org.auvsim.core.effect.Gravity;
import org.auvsim.core.entity.WorldObject;
import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.volume.Box;
import org.auvsim.core.volume.HalfSpace;
import org.auvsim.core.volume.Sphere;
import org.auvsim.core.world.World;
import org.auvsim.core.world.WorldBuilder;
import org.auvsim.core.world.WorldEvent;
import org.auvsim.core.world.WorldException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

import java.util.ArrayList;
import java.util.List;

class CoupledBodiesTest {
    static List<Stepper> steppers() {
        return List.of(SnapshotStepper.standard(), EventStepper.standard());
    }

    private static WorldObjectDefinition.Builder ball(long id, String name) {
        return WorldObjectDefinition.named(name).id(id).volume(new Sphere(0.2)).mass(2);
    }

    private static World world(Stepper stepper, double dt, WorldObjectDefinition.Builder... all) {
        WorldBuilder world = World.builder().timeStep(dt).stepper(stepper);
        for (WorldObjectDefinition.Builder body : all) {
            world.add(body.build());
        }
        return world.build();
    }

    private static void run(World world, double until) {
        while (world.time() < until) {
            world.advanceTimestep(Math.min(world.timeStep(), until - world.time()));
        }
    }

    @ParameterizedTest
    @MethodSource("steppers")
    void aSpringBetweenTwoKeepsMomentumAndEnergy(Stepper stepper) {
        PairSpring spring = new PairSpring(2, 30, 1);
        World world =
                world(
                        stepper,
                        0.01,
                        ball(1, "a").effect(spring).velocity(1, 0.5, 0),
                        ball(2, "b").position(1.5, 0, 0).mass(5).velocity(0, -1, 0.3));
        double energy = energy(world, spring);
        Vec3 momentum = momentum(world);
        for (int k = 0; k < 1000; k++) {
            world.advanceTimestep();
            assertNear(momentum(world), momentum, 1e-12);
            assertThat(energy(world, spring)).isCloseTo(energy, within(1e-5 * energy));
        }
    }

    private static Vec3 momentum(World world) {
        return world.object("a").linearMomentum().plus(world.object("b").linearMomentum());
    }

    private static double energy(World world, PairSpring spring) {
        WorldObject a = world.object("a");
        WorldObject b = world.object("b");
        return a.linearMomentum().dot(a.velocity()) / 2
                + b.linearMomentum().dot(b.velocity()) / 2
                + spring.energy(a.position(), b.position());
    }

    /** A pair that is hit by a third at about 0.52 s. */
    private static World struck(Stepper stepper, double dt, long first, long second, long third) {
        return world(
                stepper,
                dt,
                ball(first, "a").effect(new PairSpring(second, 40, 1)).velocity(0, 0.2, 0),
                ball(second, "b").position(1.2, 0, 0).angularVelocity(0, 0, 1),
                ball(third, "c").position(3, 0.05, 0).mass(4).velocity(-3, 0, 0));
    }

    private static List<Double> times(World world) {
        List<Double> times = new ArrayList<>();
        world.addListener(
                event -> {
                    if (event instanceof WorldEvent.Collided collided) {
                        times.add(collided.collision().contact().time());
                    }
                });
        return times;
    }

    @ParameterizedTest
    @MethodSource("steppers")
    void aTetheredPairHitByAThirdMovesAsWithFineSteps(Stepper stepper) {
        World fine = struck(EventStepper.standard(), 0.0005, 1, 2, 3);
        List<Double> expected = times(fine);
        run(fine, 1.5);
        World world = struck(stepper, 0.01, 1, 2, 3);
        List<Double> times = times(world);
        run(world, 1.5);
        assertThat(times).hasSameSizeAs(expected).isNotEmpty();
        double accuracy = stepper instanceof EventStepper ? 1e-7 : 1e-6;
        for (int k = 0; k < times.size(); k++) {
            assertThat(times.get(k)).isCloseTo(expected.get(k), within(accuracy));
        }
        for (String name : List.of("a", "b", "c")) {
            assertNear(world.object(name).position(), fine.object(name).position(), 2e-5);
            assertNear(world.object(name).velocity(), fine.object(name).velocity(), 2e-5);
        }
    }

    @Test
    void theOrderOfIdsMakesNoDifference() {
        World one = struck(EventStepper.standard(), 0.01, 1, 2, 3);
        run(one, 1.5);
        World other = struck(EventStepper.standard(), 0.01, 3, 1, 2);
        run(other, 1.5);
        for (String name : List.of("a", "b", "c")) {
            assertNear(one.object(name).position(), other.object(name).position(), 1e-12);
        }
    }

    @ParameterizedTest
    @MethodSource("steppers")
    void aCopyInMidRunGoesOnEqually(Stepper stepper) {
        World one = struck(stepper, 0.01, 3, 1, 2);
        run(one, 0.5);
        World copy = one.copy();
        run(one, 1);
        run(copy, 1);
        assertThat(copy.stateHash()).isEqualTo(one.stateHash());
    }

    private static WorldObjectDefinition.Builder ground() {
        return WorldObjectDefinition.named("ground").volume(new HalfSpace()).fixed();
    }

    private static WorldObjectDefinition.Builder box(long id, String name) {
        return WorldObjectDefinition.named(name)
                .id(id)
                .volume(new Box(new Vec3(1, 1, 1)))
                .mass(2)
                .restitution(0)
                .friction(0.8)
                .effect(new Gravity(10));
    }

    /** The upper one sinks on its spring and damping until k (length - gap) bears its weight. */
    @Test
    void aGroupRestsOnTheGround() {
        Damping drag = new Damping(new Vec3(4, 4, 4), Vec3.ZERO, new Vec3(1, 1, 1), Vec3.ZERO);
        World world =
                world(
                        EventStepper.standard(),
                        0.02,
                        ground(),
                        box(1, "lower")
                                .position(0, 0, 0.7)
                                .effect(drag)
                                .effect(new PairSpring(2, 100, 2)),
                        box(2, "upper").position(0, 0, 2.7).effect(drag));
        run(world, 20);
        assertThat(world.object("lower").position().z()).isCloseTo(0.5, within(1e-4));
        assertThat(world.object("upper").position().z()).isCloseTo(0.5 + 2 - 0.2, within(2e-4));
        assertThat(world.object("lower").velocity().norm()).isLessThan(1e-4);
    }

    /** Mooring lines to one anchor join nothing: each body swings as if it were alone. */
    @ParameterizedTest
    @MethodSource("steppers")
    void bodiesMooredToTheSameFixedBodySwingAlone(Stepper stepper) {
        World both =
                world(
                        stepper,
                        0.02,
                        WorldObjectDefinition.named("pole").id(9).volume(new Sphere(0.1)).fixed(),
                        ball(1, "a").position(1, 0, 0).effect(new PairSpring(9, 20, 0.8)),
                        ball(2, "b").position(-2, 0, 0).effect(new PairSpring(9, 20, 0.8)));
        World one =
                world(
                        stepper,
                        0.02,
                        WorldObjectDefinition.named("pole").id(9).volume(new Sphere(0.1)).fixed(),
                        ball(1, "a").position(1, 0, 0).effect(new PairSpring(9, 20, 0.8)));
        run(both, 0.4);
        run(one, 0.4);
        double x = 0.8 + 0.2 * StrictMath.cos(StrictMath.sqrt(10) * 0.4);
        assertThat(both.object("a").position().x()).isCloseTo(x, within(1e-7));
        assertThat(both.object("a").position()).isEqualTo(one.object("a").position());
    }

    /** A chain longer than a block: at its ends it is at rest until the wave has come there. */
    @ParameterizedTest
    @MethodSource("steppers")
    void aChainOfThreeHundredBodiesIsOneGroup(Stepper stepper) {
        WorldObjectDefinition.Builder[] links = new WorldObjectDefinition.Builder[300];
        for (int k = 0; k < links.length; k++) {
            links[k] = ball(k + 1, "link " + k).position(k, 0, 0);
            if (k > 0) {
                links[k].effect(new PairSpring(k, 1000, 1));
            }
        }
        links[0].velocity(-0.5, 0, 0);
        World world = world(stepper, 0.005, links);
        run(world, 0.5);
        Vec3 momentum = Vec3.ZERO;
        for (WorldObject link : world.objects()) {
            momentum = momentum.plus(link.linearMomentum());
        }
        assertNear(momentum, new Vec3(-1, 0, 0), 1e-11);
        assertThat(world.object("link 5").velocity().x()).isNotCloseTo(0, within(1e-3));
        assertThat(world.object("link 299").velocity().norm()).isLessThan(1e-12);
    }

    /** A pair with stiff damping, so that its segments end early, and a third that hits it. */
    @ParameterizedTest
    @MethodSource("steppers")
    void aStiffPairIsCutAsAWhole(Stepper stepper) {
        Vec3 thick = new Vec3(120, 120, 120);
        World[] worlds = new World[2];
        for (int k = 0; k < 2; k++) {
            worlds[k] =
                    world(
                            k == 0 ? stepper : EventStepper.standard(),
                            k == 0 ? 0.05 : 0.0005,
                            ball(1, "a")
                                    .effect(new PairSpring(2, 40, 1))
                                    .effect(new Damping(thick, Vec3.ZERO, thick, Vec3.ZERO))
                                    .velocity(5, 1, 0),
                            ball(2, "b").position(1.2, 0, 0),
                            ball(3, "c").position(3, 0.05, 0).mass(4).velocity(-3, 0, 0));
            run(worlds[k], 1);
        }
        for (String name : List.of("a", "b", "c")) {
            assertNear(worlds[0].object(name).position(), worlds[1].object(name).position(), 2e-3);
        }
        assertThat(worlds[0].statistics().subSteps()).isPositive();
    }

    @Test
    void whoIsNotThereIsSaid() {
        WorldObjectDefinition.Builder lost = ball(1, "a").effect(new PairSpring(7, 1, 1));
        assertThatThrownBy(() -> world(EventStepper.standard(), 0.01, lost))
                .isInstanceOf(WorldException.class)
                .hasMessageContaining("PairSpring of 'a' couples it to the id 7")
                .hasMessageContaining("1 'a'");
        WorldObjectDefinition.Builder self = ball(1, "a").effect(new PairSpring(1, 1, 1));
        assertThatThrownBy(() -> world(EventStepper.standard(), 0.01, self))
                .isInstanceOf(WorldException.class)
                .hasMessageContaining("to itself");
        World world = world(EventStepper.standard(), 0.01, ball(1, "a"));
        WorldObjectDefinition late = ball(2, "b").effect(new PairSpring(7, 1, 1)).build();
        assertThatThrownBy(() -> world.add(late)).isInstanceOf(WorldException.class);
        assertThat(world.objects()).hasSize(1);
    }

    @ParameterizedTest
    @MethodSource("steppers")
    void whenAPartnerLeavesTheCouplingEnds(Stepper stepper) {
        World world = struck(stepper, 0.01, 1, 2, 3);
        run(world, 0.2);
        world.remove(2);
        Vec3 velocity = world.object("a").velocity();
        run(world, 0.4);
        assertThat(world.object("a").velocity()).isEqualTo(velocity);
    }
}
