package org.auvsim.examples.mine;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.auvsim.core.entity.Contact;
import org.auvsim.core.entity.WorldObject;
import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.volume.Sphere;
import org.auvsim.core.world.World;
import org.auvsim.core.world.WorldBuilder;
import org.auvsim.core.world.WorldEvent;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

import java.util.ArrayList;
import java.util.List;

/** A vehicle runs into a mine that has five neighbours. */
class MineTest {
    private static final Mine MINE = new Mine(0.1, 100, 12, 50, 200);

    /** Distances from the mine (m); two are met at one instant. */
    private static final double[] DISTANCES = {3, 4.5, 4.5, 8, 11};

    private final List<Contact> contacts = new ArrayList<>();
    private World world = World.builder().build();

    @BeforeEach
    void explode() {
        WorldBuilder builder =
                World.builder()
                        .timeStep(0.01)
                        .add(ball("Mine", 10).response(MINE).build())
                        .add(ball("Vehicle", 10).position(-1.01, 0, 0).velocity(2, 0, 0).build())
                        .add(ball("Far", 10).position(0, -20, 0).build());
        for (int i = 0; i < DISTANCES.length; i++) {
            double angle = i - 2;
            Vec3 place = new Vec3(StrictMath.cos(angle), 0, StrictMath.sin(angle));
            builder.add(ball("Neighbour " + i, 10).position(place.times(DISTANCES[i])).build());
        }
        world = builder.build();
        world.addListener(
                event -> {
                    if (event instanceof WorldEvent.Collided collided) {
                        contacts.add(collided.collision().contact());
                    }
                });
        while (world.time() < 0.5) {
            world.advanceTimestep();
        }
    }

    private static WorldObjectDefinition.Builder ball(String name, double mass) {
        return WorldObjectDefinition.named(name)
                .volume(new Sphere(0.5))
                .mass(mass)
                .component(new Hull("hull", 100));
    }

    private List<Contact> with(String name) {
        return contacts.stream().filter(c -> c.self().name().equals(name)).toList();
    }

    private double explosion() {
        return with("Mine").getFirst().time();
    }

    private double strength(String name) {
        return world.object(name).component(Hull.class).orElseThrow().strength();
    }

    @Test
    void theMineIsGoneAndTheWaveHasRunOut() {
        assertThat(explosion()).isEqualTo(0.005, within(1e-9));
        assertThat(world.entities())
                .hasSize(7)
                .allMatch(e -> e instanceof WorldObject && !e.name().equals("Mine"));
    }

    @Test
    void eachNeighbourIsMetOnceWhenTheFrontReachesIt() {
        for (int i = 0; i < DISTANCES.length; i++) {
            List<Contact> met = with("Neighbour " + i);

            assertThat(met).hasSize(1);
            assertThat(met.getFirst().time() - explosion())
                    .isEqualTo((DISTANCES[i] - 0.5 - MINE.core()) / MINE.speed(), within(1e-9));
        }
    }

    @Test
    void damageAndPushFallWithTheSquareOfTheDistance() {
        for (int i = 0; i < DISTANCES.length; i++) {
            String name = "Neighbour " + i;
            double surface = DISTANCES[i] - 0.5;
            double share = 1 / (surface * surface);

            assertThat(strength(name)).isEqualTo(100 - MINE.damage() * share, within(1e-6));
            WorldObject neighbour = world.object(name);
            assertThat(neighbour.linearMomentum().norm())
                    .isEqualTo(MINE.impulse() * share, within(1e-6));
            assertThat(neighbour.velocity().dot(neighbour.position())).isPositive();
        }
    }

    @Test
    void theVehicleBouncesOffTheMineAndIsThenStruckItself() {
        List<Contact> met = contacts.stream().filter(c -> involves(c, "Vehicle")).toList();
        assertThat(met).hasSize(2);

        // Off an equal mass it comes to rest; then the wave, 0.5 m wide, pushes and damages it.
        double surface = 0.5;
        assertThat(world.object("Vehicle").linearMomentum().x())
                .isEqualTo(-MINE.impulse() / (surface * surface), within(1e-4));
        assertThat(strength("Vehicle")).isZero();
    }

    private static boolean involves(Contact c, String name) {
        return c.self().name().equals(name) || c.other().name().equals(name);
    }

    @Test
    void whatIsOutOfReachIsLeftAlone() {
        assertThat(with("Far")).isEmpty();
        assertThat(strength("Far")).isEqualTo(100);
        assertThat(world.object("Far").velocity()).isEqualTo(Vec3.ZERO);
    }
}
