package org.auvsim.core.step;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;
import static org.auvsim.core.math.Near.assertNear;

import org.auvsim.core.effect.Damping;
import org.auvsim.core.effect.Gravity;
import org.auvsim.core.entity.AddedMass;
import org.auvsim.core.entity.AddedMassTerm;
import org.auvsim.core.entity.Inertia;
import org.auvsim.core.entity.MotionAxis;
import org.auvsim.core.entity.WorldObject;
import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.volume.Box;
import org.auvsim.core.volume.HalfSpace;
import org.auvsim.core.volume.Sphere;
import org.auvsim.core.world.World;
import org.auvsim.core.world.WorldBuilder;
import org.auvsim.core.world.WorldEvent;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.IntConsumer;
import java.util.stream.IntStream;

/**
 * The REMUS with its printed damping (Prestero 2001, as used with Yvv -1310, Mqq -188, Nrr -94),
 * with which a Runge-Kutta step of 0.05 s diverges.
 */
class StiffBodiesTest {
    private static WorldObjectDefinition.Builder remus() {
        return remus("REMUS");
    }

    private static WorldObjectDefinition.Builder remus(String name) {
        return WorldObjectDefinition.named(name)
                .volume(new Box(new Vec3(1.33, 0.19, 0.19)))
                .mass(30.48)
                .inertia(new Inertia(0.177, 3.45, 3.45, 0, 0, 0))
                .centreOfMass(new Vec3(0, 0, -0.0196))
                .addedMass(
                        new AddedMass(
                                new Vec3(0.93, 35.5, 35.5),
                                new Vec3(0.0704, 4.88, 4.88),
                                List.of(
                                        new AddedMassTerm(MotionAxis.SWAY, MotionAxis.YAW, -1.93),
                                        new AddedMassTerm(
                                                MotionAxis.HEAVE, MotionAxis.PITCH, 1.93))))
                .effect(
                        new Damping(
                                Vec3.ZERO,
                                new Vec3(1.62, 1310, 131),
                                Vec3.ZERO,
                                new Vec3(0.13, 188, 94)));
    }

    static List<Stepper> steppers() {
        Stepper snapshots =
                new SnapshotStepper(
                        new NoRestricter(), new AllPairsPartitioner(), new EndOfStepFinder());
        return List.of(snapshots, EventStepper.standard());
    }

    private static World world(
            Stepper stepper, double dt, WorldObjectDefinition.Builder... bodies) {
        return world(stepper, dt, Lanes.ONE, bodies);
    }

    private static World world(
            Stepper stepper, double dt, Lanes lanes, WorldObjectDefinition.Builder... bodies) {
        WorldBuilder world = World.builder().timeStep(dt).stepper(stepper).lanes(lanes);
        for (WorldObjectDefinition.Builder body : bodies) {
            world.add(body.build());
        }
        return world.build();
    }

    private static WorldObject after(World world, int steps) {
        for (int i = 0; i < steps; i++) {
            world.advanceTimestep();
        }
        return world.object("REMUS");
    }

    @ParameterizedTest
    @MethodSource("steppers")
    void theRemusSlowsDownAsWithAThousandTimesSmallerSteps(Stepper stepper) {
        WorldObjectDefinition.Builder sway = remus().velocity(1.5, 3, 0).angularVelocity(0, 3, 0.5);
        World coarse = world(stepper, 0.05, sway);
        WorldObject body = after(coarse, 40);
        WorldObject fine = after(world(stepper, 0.00005, sway), 40_000);
        assertNear(body.velocity(), fine.velocity(), 0.02);
        assertNear(body.angularVelocity(), fine.angularVelocity(), 0.02);
        assertNear(body.position(), fine.position(), 0.03);
        assertThat(body.velocity().norm()).isLessThan(1.5);
        assertThat(coarse.statistics().subSteps()).isBetween(2L, 400L);
    }

    @ParameterizedTest
    @MethodSource("steppers")
    void ordinaryDampingIsNotCut(Stepper stepper) {
        World world =
                world(
                        stepper,
                        0.05,
                        WorldObjectDefinition.named("REMUS")
                                .volume(new Box(new Vec3(1, 1, 1)))
                                .mass(30)
                                .velocity(2, 1, 0)
                                .effect(
                                        new Damping(
                                                new Vec3(5, 5, 5),
                                                new Vec3(10, 10, 10),
                                                new Vec3(1, 1, 1),
                                                Vec3.ZERO)));
        after(world, 100);
        assertThat(world.statistics().subSteps()).isZero();
    }

    @ParameterizedTest
    @MethodSource("steppers")
    void whatIsTooStiffIsSaidAndNothingHasMoved(Stepper stepper) {
        Vec3 huge = new Vec3(1e9, 1e9, 1e9);
        World world =
                world(
                        stepper,
                        0.05,
                        remus().velocity(1, 0, 0)
                                .effect(new Damping(huge, Vec3.ZERO, Vec3.ZERO, Vec3.ZERO)));
        long before = world.stateHash();
        assertThatThrownBy(world::advanceTimestep)
                .isInstanceOf(StepException.class)
                .hasMessageContaining("'REMUS'")
                .hasMessageContaining("too stiff");
        assertThat(world.stateHash()).isEqualTo(before);
    }

    private static final Damping THICK =
            new Damping(
                    new Vec3(100, 100, 100), Vec3.ZERO, new Vec3(20, 20, 20), new Vec3(1, 1, 1));

    private static WorldObjectDefinition.Builder ball(String name) {
        return WorldObjectDefinition.named(name).volume(new Sphere(0.5)).mass(1);
    }

    /** dv/dt = -100/s v: v = v0 exp(-100 t), x = x0 + v0/100 (1 - exp(-100 t)). */
    @Test
    void aStiffBodyMeetsAnotherWhereItIsWithinTheFrame() {
        double speed = 30;
        double gap = 0.2;
        double hit = -StrictMath.log(1 - 100 * gap / speed) / 100;
        List<Double> times = new ArrayList<>();
        World world =
                world(
                        EventStepper.standard(),
                        0.05,
                        ball("stiff").velocity(speed, 0, 0).effect(THICK),
                        ball("heavy").position(1 + gap, 0, 0).mass(1e6));
        world.addListener(
                event -> {
                    if (event instanceof WorldEvent.Collided collided) {
                        times.add(collided.collision().contact().time());
                    }
                });
        world.advanceTimestep();
        assertThat(times).hasSize(1);
        assertThat(times.getFirst()).isCloseTo(hit, within(2e-4));
        double back = -(speed - 100 * gap) * StrictMath.exp(-100 * (0.05 - hit));
        assertThat(world.object("stiff").velocity().x()).isCloseTo(back, within(0.02));
        assertThat(world.statistics().subSteps()).isPositive();
    }

    private static WorldObjectDefinition.Builder ground() {
        return WorldObjectDefinition.named("ground")
                .volume(new HalfSpace())
                .position(0, 0, 0)
                .fixed();
    }

    /** The drag in a fluid must not weaken what the ground bears: it sinks by nothing. */
    @Test
    void aDampedBodyRestsOnTheGround() {
        Vec3 drag = new Vec3(10, 10, 10);
        World world =
                world(
                        EventStepper.standard(),
                        0.05,
                        ground(),
                        box("box")
                                .position(0, 0, 0.6)
                                .effect(new Damping(drag, Vec3.ZERO, drag, Vec3.ZERO))
                                .effect(new Gravity(9.8)));
        for (int k = 0; k < 200; k++) {
            world.advanceTimestep();
        }
        assertThat(world.object("box").position().z()).isCloseTo(0.5, within(2e-5));
        assertThat(world.object("box").velocity().norm()).isLessThan(1e-6);
    }

    @Test
    void aStiffBodyComesToRestOnTheGroundWithAnotherOnTop() {
        World world =
                world(
                        EventStepper.standard(),
                        0.05,
                        ground(),
                        box("lower").position(0, 0, 0.6).effect(THICK).effect(new Gravity(9.8)),
                        box("upper").position(0.1, 0, 1.7).effect(new Gravity(9.8)));
        for (int k = 0; k < 200; k++) {
            world.advanceTimestep();
        }
        assertThat(world.object("lower").position().z()).isCloseTo(0.5, within(1e-4));
        assertThat(world.object("upper").position().z()).isCloseTo(1.5, within(2e-4));
        assertThat(world.object("upper").velocity().norm()).isLessThan(1e-4);
        assertThat(world.statistics().subSteps()).isPositive();
    }

    private static WorldObjectDefinition.Builder box(String name) {
        return WorldObjectDefinition.named(name)
                .volume(new Box(new Vec3(1, 1, 1)))
                .mass(1)
                .restitution(0)
                .friction(0.5);
    }

    /** Stiff and plain balls among each other, in more than one block. */
    private static World crowd(Lanes lanes) {
        SplittableRandom random = new SplittableRandom(5);
        WorldObjectDefinition.Builder[] balls = new WorldObjectDefinition.Builder[600];
        for (int k = 0; k < balls.length; k++) {
            balls[k] =
                    ball("ball " + k)
                            .position(1.1 * (k % 7), 1.1 * (k / 7 % 7), 1.1 * Math.floorDiv(k, 49))
                            .velocity(
                                    random.nextDouble(-9, 9),
                                    random.nextDouble(-9, 9),
                                    random.nextDouble(-9, 9));
            if (k % 3 == 0) {
                balls[k].effect(THICK);
            }
        }
        return world(EventStepper.standard(), 0.05, lanes, balls);
    }

    @Test
    void stiffBodiesMoveEquallyInOneLaneAndInMany() {
        World one = crowd(Lanes.ONE);
        AtomicInteger runs = new AtomicInteger();
        World four = crowd(four(runs));
        for (int k = 0; k < 10; k++) {
            one.advanceTimestep();
            four.advanceTimestep();
            assertThat(four.stateHash()).isEqualTo(one.stateHash());
        }
        assertThat(runs).as("how often lanes ran").hasPositiveValue();
        assertThat(one.statistics()).isEqualTo(four.statistics());
        assertThat(one.statistics().subSteps()).isGreaterThan(100);
        assertThat(one.statistics().collisions()).isGreaterThan(100);
    }

    /** They are cut together, each until it is fine itself. */
    @ParameterizedTest
    @MethodSource("steppers")
    void aStiffBodyMovesAmongOthersAsAlone(Stepper stepper) {
        List<WorldObjectDefinition.Builder> bodies = new ArrayList<>();
        for (int k = 0; k < 5; k++) {
            Vec3 thick = new Vec3(20 * k * k, 60 * k, 10);
            bodies.add(
                    remus("REMUS " + k)
                            .position(0, 40 * k, 0)
                            .velocity(1.5, 0.7 * k, -0.3)
                            .angularVelocity(0.1, 0.6 * k, 0.5)
                            .effect(new Damping(thick, Vec3.ZERO, thick, Vec3.ZERO)));
        }
        World all = world(stepper, 0.05, bodies.toArray(WorldObjectDefinition.Builder[]::new));
        List<World> each = bodies.stream().map(body -> world(stepper, 0.05, body)).toList();
        for (int step = 0; step < 20; step++) {
            all.advanceTimestep();
            for (int k = 0; k < 5; k++) {
                each.get(k).advanceTimestep();
                WorldObject among = all.object("REMUS " + k);
                WorldObject alone = each.get(k).object("REMUS " + k);
                assertThat(among.position()).isEqualTo(alone.position());
                assertThat(among.orientation()).isEqualTo(alone.orientation());
                assertThat(among.velocity()).isEqualTo(alone.velocity());
                assertThat(among.angularVelocity()).isEqualTo(alone.angularVelocity());
            }
        }
        assertThat(all.statistics().subSteps())
                .isEqualTo(each.stream().mapToLong(w -> w.statistics().subSteps()).sum())
                .isGreaterThan(50);
    }

    @Test
    void lanesDoNotRunForFewBodies() {
        AtomicInteger runs = new AtomicInteger();
        World few =
                world(
                        EventStepper.standard(),
                        0.05,
                        four(runs),
                        ball("one"),
                        ball("two").position(5, 0, 0));
        few.advanceTimestep();
        assertThat(runs).hasValue(0);
    }

    /** Four lanes that count how often they run. */
    private static Lanes four(AtomicInteger runs) {
        return new Lanes() {
            @Override
            public int count() {
                return 4;
            }

            @Override
            public void run(IntConsumer part) {
                runs.incrementAndGet();
                IntStream.range(0, 4).parallel().forEach(part);
            }
        };
    }
}
