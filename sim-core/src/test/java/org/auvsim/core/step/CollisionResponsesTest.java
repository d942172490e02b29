package org.auvsim.core.step;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import org.auvsim.core.dynamics.ImpulseResponse;
import org.auvsim.core.entity.Change;
import org.auvsim.core.entity.CollisionResponse;
import org.auvsim.core.entity.Contact;
import org.auvsim.core.entity.WorldObject;
import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.volume.Box;
import org.auvsim.core.world.World;
import org.auvsim.core.world.WorldBuilder;
import org.auvsim.core.world.WorldEvent;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;

/** The last stage: what happens when everything has moved to the instant of contact. */
class CollisionResponsesTest {
    /** Notes the velocities that it is shown, and bounces. */
    private record Observant(List<String> notes) implements CollisionResponse {
        @Override
        public List<Change> respond(Contact contact) {
            notes.add(
                    "%s sees %s at %s"
                            .formatted(
                                    contact.self().name(),
                                    contact.other().name(),
                                    contact.other().body().orElseThrow().velocity()));
            return new ImpulseResponse().respond(contact);
        }
    }

    private static WorldObjectDefinition ball(String name, double x, double speed, double mass) {
        return Scene.ball(name, 0.5).mass(mass).position(x, 0, 0).velocity(speed, 0, 0).build();
    }

    @Test
    void ofThreeBodiesAtOnceEachIsAskedBeforeAnyChanges() {
        List<String> notes = new ArrayList<>();
        World world =
                World.builder()
                        .stepper(SnapshotStepper.standard())
                        .response(new Observant(notes))
                        .add(ball("A", -1.3, 1, 1))
                        .add(ball("B", 0, 0, 1))
                        .add(ball("C", 1.3, -1, 1))
                        .timeStep(0.5)
                        .build();

        world.advanceTimestep();

        assertThat(world.time()).isEqualTo(0.3, within(1e-9));
        assertThat(notes)
                .containsExactly(
                        "A sees B at (0.0, 0.0, 0.0)",
                        "B sees A at (1.0, 0.0, 0.0)",
                        "B sees C at (-1.0, 0.0, 0.0)",
                        "C sees B at (0.0, 0.0, 0.0)");
        assertThat(world.object("B").linearMomentum()).isEqualTo(Vec3.ZERO);
    }

    @Test
    void momentaThatSeveralGiveAddUp() {
        World world =
                World.builder()
                        .add(ball("A", -1.3, 1, 1))
                        .add(ball("B", 0, 0, 1e6))
                        .add(ball("C", 1.3, -1, 2))
                        .timeStep(0.5)
                        .build();

        world.advanceTimestep();

        // Each bounces off B as off a wall, and B gets the difference.
        assertThat(world.object("A").linearMomentum().x()).isEqualTo(-1, within(1e-5));
        assertThat(world.object("C").linearMomentum().x()).isEqualTo(2, within(1e-5));
        assertThat(world.object("B").linearMomentum().x()).isEqualTo(-2, within(1e-5));
    }

    /** Adds an object that is named after the responder. */
    private record LeavesATrace() implements CollisionResponse {
        @Override
        public List<Change> respond(Contact contact) {
            return List.of(
                    new Change.AddObject(
                            Scene.ball("Trace of " + contact.self().name(), 0.1)
                                    .position(90.0 * contact.self().id(), 0, 0)
                                    .build()));
        }
    }

    @Test
    void changesAreMadeInOrderOfTheIdsOfWhoResponded() {
        World world =
                World.builder()
                        .stepper(SnapshotStepper.standard())
                        .response(new LeavesATrace())
                        .add(Scene.ball("Late", 0.5).id(8).build())
                        .add(
                                Scene.ball("Early", 0.5)
                                        .id(3)
                                        .position(1.1, 0, 0)
                                        .velocity(-3, 0, 0)
                                        .build())
                        .build();

        world.advanceTimestep();

        assertThat(world.objects())
                .extracting(WorldObject::name)
                .containsExactly("Early", "Late", "Trace of Early", "Trace of Late");
    }

    /** Responds for one of the two; the other bounces. */
    private record Faulty(String who, CollisionResponse fault) implements CollisionResponse {
        @Override
        public List<Change> respond(Contact contact) {
            return (contact.self().name().equals(who) ? fault : new ImpulseResponse())
                    .respond(contact);
        }
    }

    private static List<Change> throwing(Contact contact) {
        throw new IllegalStateException("no table for " + contact.other().name());
    }

    /** The first of its changes can be made, the second leads out of all numbers. */
    private static List<Change> overflowing(Contact contact) {
        Change most = new Change.Momentum(contact.self().id(), new Vec3(1.5e308, 0, 0), Vec3.ZERO);
        return List.of(most, most);
    }

    @ParameterizedTest(name = "B''s response {0}")
    @ValueSource(strings = {"throws", "overflows"})
    void aResponseThatFailsLeavesTheWorldAsItWas(String how) {
        CollisionResponse fault =
                how.equals("throws")
                        ? CollisionResponsesTest::throwing
                        : CollisionResponsesTest::overflowing;
        World world =
                World.builder()
                        .response(new Faulty("B", fault))
                        .add(ball("A", -1.25, 1, 1))
                        .add(ball("B", 0, 0, 1))
                        .timeStep(0.5)
                        .build();
        List<WorldEvent> events = new ArrayList<>();
        world.addListener(events::add);
        long before = world.stateHash();

        assertThatThrownBy(world::advanceTimestep)
                .isInstanceOf(StepException.class)
                .hasMessageContainingAll("the collision of", "'A' (id 1)", "'B' (id 2)", " at 0.2")
                .hasMessageEndingWith("; check their collision responses")
                .hasCauseInstanceOf(
                        how.equals("throws")
                                ? IllegalStateException.class
                                : IllegalArgumentException.class);

        assertThat(world.time()).isZero();
        assertThat(world.stateHash()).isEqualTo(before);
        assertThat(events).isEmpty();
        // It can go on: up to the collision nothing is wrong.
        world.advanceTimestep(0.125);
        assertThat(world.object("A").position().x()).isEqualTo(-1.125, within(1e-12));
    }

    @Test
    void theImpulseToldIsWhatTheFirstOfTheTwoReceived() {
        World world = World.builder().add(ball("A", 0, 0, 1)).add(ball("B", 1.1, -3, 1)).build();
        List<Vec3> impulses = new ArrayList<>();
        world.addListener(
                event -> {
                    if (event instanceof WorldEvent.Collided collided) {
                        impulses.add(collided.collision().impulse());
                    }
                });

        world.advanceTimestep();

        assertThat(impulses).hasSize(1);
        assertThat(impulses.getFirst().distance(world.object("A").linearMomentum())).isZero();
        assertThat(impulses.getFirst().x()).isEqualTo(-3, within(1e-9));
    }

    @ParameterizedTest(name = "seed {0}")
    @ValueSource(longs = {1, 2, 3})
    void aClosedBoxOfFixedWallsKeepsTheEnergy(long seed) {
        World world = box(seed);
        int[] collisions = {0};
        world.addListener(event -> collisions[0] += event instanceof WorldEvent.Collided ? 1 : 0);
        double energy = energy(world);

        while (world.time() < 10) {
            world.advanceTimestep();
        }

        assertThat(collisions[0]).isGreaterThan(25);
        assertThat(energy(world)).isEqualTo(energy, within(1e-8 * energy));
        assertThat(world.objects())
                .allMatch(o -> o.isFixed() || o.position().norm() < Math.sqrt(3) * 2);
    }

    /** A room of 4 m, closed by walls 1 m thick, with eight balls. */
    private static World box(long seed) {
        SplittableRandom random = new SplittableRandom(seed);
        WorldBuilder builder = World.builder();
        for (int side = 0; side < 6; side++) {
            double out = side % 2 == 0 ? 2.5 : -2.5;
            Vec3 centre =
                    new Vec3(
                            side / 2 == 0 ? out : 0,
                            side / 2 == 1 ? out : 0,
                            side / 2 == 2 ? out : 0);
            Vec3 size =
                    new Vec3(side / 2 == 0 ? 1 : 6, side / 2 == 1 ? 1 : 6, side / 2 == 2 ? 1 : 6);
            builder.add(
                    WorldObjectDefinition.named("Wall " + side)
                            .volume(new Box(size))
                            .fixed()
                            .position(centre)
                            .build());
        }
        for (int i = 0; i < 8; i++) {
            builder.add(
                    Scene.ball("Ball " + i, random.nextDouble(0.2, 0.6))
                            .mass(random.nextDouble(0.5, 3))
                            .position((i & 1) * 2 - 1, (i & 2) - 1, (i & 4) / 2.0 - 1)
                            .velocity(
                                    random.nextDouble(-2, 2),
                                    random.nextDouble(-2, 2),
                                    random.nextDouble(-2, 2))
                            .angularVelocity(random.nextDouble(-3, 3), 0, 1)
                            .build());
        }
        return builder.build();
    }

    private static double energy(World world) {
        return world.objects().stream()
                .filter(o -> !o.isFixed())
                .mapToDouble(
                        o ->
                                o.linearMomentum().dot(o.velocity()) / 2
                                        + o.angularMomentum().dot(o.angularVelocity()) / 2)
                .sum();
    }
}
