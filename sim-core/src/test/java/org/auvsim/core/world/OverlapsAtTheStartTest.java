package org.auvsim.core.world;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.step.SnapshotStepper;
import org.auvsim.core.volume.Box;
import org.auvsim.core.volume.HalfSpace;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.util.SplittableRandom;

class OverlapsAtTheStartTest {
    private static WorldObjectDefinition.Builder crate(String name) {
        return WorldObjectDefinition.named(name).mass(1).volume(new Box(new Vec3(1, 1, 1)));
    }

    private static WorldObjectDefinition ground() {
        return WorldObjectDefinition.named("Ground").fixed().volume(new HalfSpace()).build();
    }

    @Test
    void allPairsAreToldWithTheirDepths() {
        WorldBuilder world =
                World.builder()
                        .add(Balls.at("A", 0))
                        .add(Balls.at("B", 0.75))
                        .add(Balls.at("Far", 20))
                        .add(ground())
                        .add(crate("Crate").position(50, 0, 0.25).build());

        assertThatThrownBy(world::build)
                .isInstanceOf(WorldException.class)
                .hasMessage(
                        "objects overlap at the start: 'A' (id 1) and 'B' (id 2) by 0.250 m,"
                                + " 'A' (id 1) and 'Ground' (id 4) by 0.500 m,"
                                + " 'B' (id 2) and 'Ground' (id 4) by 0.500 m,"
                                + " 'Far' (id 3) and 'Ground' (id 4) by 0.500 m,"
                                + " 'Ground' (id 4) and 'Crate' (id 5) by 0.250 m;"
                                + " move them apart or set allow-overlaps");
    }

    @Test
    void ofManyPairsTenAreToldAndTheOthersCounted() {
        WorldBuilder world = World.builder();
        for (int i = 0; i < 50; i++) {
            world.add(Balls.at("Ball " + i, 0.9 * i));
        }

        assertThatThrownBy(world::build)
                .hasMessageContaining("'Ball 9' (id 10) and 'Ball 10' (id 11) by 0.100 m")
                .hasMessageNotContaining("'Ball 11'")
                .hasMessageContaining(" and 39 pairs more; move them apart");
    }

    @Test
    void touchingIsNoOverlap() {
        World world =
                World.builder()
                        .add(ground())
                        .add(crate("Lower").position(0.1, 0.2, 0.5).build())
                        .add(crate("Upper").position(0.1, 0.2, 0.1 + 0.2 + 1.2).build())
                        .add(Balls.ball("Left").position(10.1, 0, 5).build())
                        .add(Balls.ball("Right").position(10.1 + 0.7 + 0.3, 0, 5).build())
                        .build();

        assertThat(world.objects()).hasSize(5);
    }

    @Test
    void whatNeverMeetsMayOverlap() {
        World world =
                World.builder()
                        .add(Balls.ball("Rock").fixed().build())
                        .add(Balls.ball("Reef").fixed().position(0.5, 0, 0).build())
                        .add(Balls.ball("Ghost").layer(3).ignores(0).position(0.2, 0, 0).build())
                        .build();

        assertThat(world.objects()).hasSize(3);
    }

    @Test
    void allowedOverlapsAreLetBe() {
        World world =
                World.builder()
                        .add(Balls.at("A", 0))
                        .add(Balls.at("B", 0.75))
                        .allowOverlaps()
                        .build();

        assertThat(world.overlaps(1)).containsExactly(2L);
    }

    /** Against every pair by its centres. */
    @ParameterizedTest(name = "seed {0}")
    @ValueSource(longs = {1, 2, 3})
    void noneIsOverlookedAmongMany(long seed) {
        SplittableRandom random = new SplittableRandom(seed);
        Vec3[] place = new Vec3[300];
        WorldBuilder builder = World.builder();
        int overlaps = 0;
        for (int i = 0; i < place.length; i++) {
            place[i] =
                    new Vec3(
                            random.nextDouble(-9, 9),
                            random.nextDouble(-9, 9),
                            random.nextDouble(-9, 9));
            builder.add(Balls.ball("Ball " + i).position(place[i]).build());
            for (int j = 0; j < i; j++) {
                overlaps += place[i].distance(place[j]) < 1 ? 1 : 0;
            }
        }

        assertThatThrownBy(builder::build)
                .hasMessageContaining(" and " + (overlaps - 10) + " pairs more");
    }

    @Test
    void collidingAsBoundingSpheresTheyOverlapAsThese() {
        WorldBuilder world =
                World.builder()
                        .asBoundingSpheres()
                        .add(crate("A").build())
                        .add(crate("B").position(1.5, 0, 0).build());

        assertThatThrownBy(world::build).hasMessageContaining("by 0.232 m");
    }

    @Test
    void whatHasNoBoundingSphereIsRefusedWhereItNeedsOne() {
        WorldBuilder world = World.builder().asBoundingSpheres().add(ground());

        assertThatThrownBy(world::build)
                .isInstanceOf(WorldException.class)
                .hasMessageStartingWith(
                        "'Ground' has no bounding sphere, as its volume has no end");
    }

    /** Spheres round two cubes of 1 m touch while the cubes are sqrt 3 - 1 m apart. */
    @ParameterizedTest(name = "{0}")
    @ValueSource(booleans = {false, true})
    void inBoundingSphereModeBothSteppersCollideTheSpheres(boolean snapshot) {
        WorldBuilder builder =
                World.builder()
                        .asBoundingSpheres()
                        .timeStep(0.1)
                        .add(crate("A").build())
                        .add(crate("B").position(4, 0, 0).velocity(-1, 0, 0).build());
        if (snapshot) {
            builder.stepper(SnapshotStepper.standard());
        }
        World world = builder.build();
        double[] met = {Double.NaN};
        world.addListener(
                event -> {
                    if (event instanceof WorldEvent.Collided collided) {
                        met[0] = collided.time();
                    }
                });

        while (world.time() < 3) {
            world.advanceTimestep();
        }

        assertThat(met[0]).isEqualTo(4 - Math.sqrt(3), within(1e-9));
        assertThat(world.object("A").velocity().x()).isEqualTo(-1, within(1e-9));
    }

    /** Layers hold for both ways to make a step. */
    @ParameterizedTest(name = "{0}")
    @ValueSource(booleans = {false, true})
    void aLayerThatIsIgnoredIsPassedThrough(boolean snapshot) {
        WorldBuilder builder =
                World.builder()
                        .add(Balls.ball("Rock").layer(2).build())
                        .add(
                                Balls.ball("Ghost")
                                        .ignores(2)
                                        .position(2, 0, 0)
                                        .velocity(-1, 0, 0)
                                        .build());
        if (snapshot) {
            builder.stepper(SnapshotStepper.standard());
        }
        World world = builder.build();

        while (world.time() < 4) {
            world.advanceTimestep();
        }

        assertThat(world.object("Ghost").position().x()).isEqualTo(2 - world.time(), within(1e-9));
    }
}
