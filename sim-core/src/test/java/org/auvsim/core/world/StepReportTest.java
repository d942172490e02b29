package org.auvsim.core.world;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.core.effect.Damping;
import org.auvsim.core.effect.Gravity;
import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.core.math.Draws;
import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.volume.Box;
import org.auvsim.core.volume.HalfSpace;
import org.junit.jupiter.api.Test;

import java.util.ArrayList;
import java.util.List;

/** What keeps a step from getting stuck or diverging is told, and only then. */
class StepReportTest {
    private static final int ROW = 10;
    private static final int LAYER = ROW * ROW;
    private static final int HAIL = 30;

    private final List<WorldEvent> events = new ArrayList<>();

    private World heard(WorldObjectDefinition... objects) {
        WorldBuilder builder = World.builder();
        List.of(objects).forEach(builder::add);
        World world = builder.build();
        world.addListener(events::add);
        return world;
    }

    private static WorldObjectDefinition floor() {
        return WorldObjectDefinition.named("Floor").volume(new HalfSpace()).fixed().build();
    }

    private static WorldObjectDefinition box(String name, double x) {
        return WorldObjectDefinition.named(name)
                .volume(new Box(new Vec3(1, 1, 1)))
                .mass(1)
                .restitution(0.5)
                .effect(new Gravity(9.81))
                .position(x, 0, 0.5)
                .build();
    }

    private List<WorldEvent.StepReport> reports() {
        return events.stream()
                .filter(WorldEvent.StepReport.class::isInstance)
                .map(WorldEvent.StepReport.class::cast)
                .toList();
    }

    @Test
    void boxesThatRestAreReportedEachStepAsHeldPairs() {
        World world = heard(floor(), box("One", 0), box("Other", 7));
        world.advanceTimestep();
        events.clear();

        for (int step = 0; step < 5; step++) {
            world.advanceTimestep();

            assertThat(reports())
                    .containsExactly(new WorldEvent.StepReport(world.time(), 0, 2, 0, 0, 0, 0));
            assertThat(events.get(events.size() - 2)).isInstanceOf(WorldEvent.StepReport.class);
            assertThat(events.getLast()).isInstanceOf(WorldEvent.StepAdvanced.class);
            events.clear();
        }
    }

    @Test
    void collisionsWithoutLossAreReported() {
        // 4 ms after it has met a wall the ball is back, unless the other wall holds it.
        World world =
                heard(
                        wall("Left", -0.51, 1),
                        wall("Right", 0.51, -1),
                        Balls.ball("Ball").restitution(0.9).velocity(10, 0, 0).build());

        world.advanceTimestep();

        assertThat(reports()).hasSize(1);
        assertThat(reports().getFirst().quickHits())
                .isPositive()
                .isEqualTo(world.statistics().quickHits());
    }

    /** A hail on a layer of balls that lie side by side: each hit settles the layer anew. */
    @Test
    void hitsOnACrowdAreReported() {
        List<WorldObjectDefinition> objects = new ArrayList<>(List.of(floor()));
        for (int i = 0; i < LAYER; i++) {
            objects.add(ball("Lying " + i, i, 0.5, 0));
        }
        for (int i = 0; i < HAIL; i++) {
            objects.add(ball("Falling " + i, i, 1.5 + 0.01 * (i + 1), -10));
        }
        World world = heard(objects.toArray(WorldObjectDefinition[]::new));

        world.advanceTimestep();

        assertThat(reports()).hasSize(1);
        assertThat(reports().getFirst().crowdedHits())
                .isPositive()
                .isLessThan(HAIL)
                .isEqualTo(world.statistics().crowdedHits());
    }

    private static WorldObjectDefinition ball(String name, int cell, double height, double speed) {
        return Balls.ball(name)
                .restitution(0.5)
                .effect(new Gravity(9.81))
                .position(cell % ROW, Math.floorDiv(cell, ROW), height)
                .velocity(0, 0, speed)
                .build();
    }

    /** With friction, a rod that bounces by all of its restitution would gain energy from spin. */
    @Test
    void restitutionThatIsLoweredIsReported() {
        World world =
                heard(
                        roughFloor(),
                        rough(WorldObjectDefinition.named("Rod"))
                                .volume(new Box(new Vec3(0.2, 0.4, 2)))
                                .mass(1)
                                .restitution(0.9)
                                .effect(new Gravity(9.81))
                                .position(0, 0, 1.2)
                                .orientation(new Quat(-0.5, -0.85, -0.18, 0.02).normalized())
                                .velocity(0, -0.9, -1.4)
                                .angularVelocity(-5.5, -9.7, -8.4)
                                .build());

        while (world.statistics().collisions() == 0) {
            world.advanceTimestep();
        }

        assertThat(world.statistics().loweredHits()).isEqualTo(1);
        assertThat(reports()).hasSize(1);
        assertThat(reports().getFirst().loweredHits()).isEqualTo(1);
    }

    private static WorldObjectDefinition roughFloor() {
        return rough(WorldObjectDefinition.named("Floor")).volume(new HalfSpace()).fixed().build();
    }

    private static WorldObjectDefinition.Builder rough(WorldObjectDefinition.Builder body) {
        return body.friction(1);
    }

    @Test
    void islandsWhoseForcesAreNotFoundAreReported() {
        Draws draws = new Draws(3);
        List<WorldObjectDefinition> objects = new ArrayList<>();
        objects.add(roughFloor());
        for (int i = 0; i < 5; i++) {
            objects.add(
                    rough(WorldObjectDefinition.named("Tumbling " + i))
                            .volume(new Box(new Vec3(1, 1, 1)))
                            .mass(1)
                            .restitution(0)
                            .effect(new Gravity(9.81))
                            .position(0, 0, 1 + 1.8 * i)
                            .orientation(draws.orientation())
                            .build());
        }
        World world = heard(objects.toArray(WorldObjectDefinition[]::new));

        while (world.time() < 2) {
            world.advanceTimestep();
        }

        assertThat(reports().stream().mapToLong(WorldEvent.StepReport::unsolvedIslands).sum())
                .isPositive()
                .isEqualTo(world.statistics().unsolvedIslands());
    }

    /** A plane across the x axis, solid on the side that {@code normal}, 1 or -1, points from. */
    private static WorldObjectDefinition wall(String name, double x, double normal) {
        return WorldObjectDefinition.named(name)
                .volume(new HalfSpace())
                .fixed()
                .position(x, 0, 0)
                .orientation(new Quat(1, 0, normal, 0).normalized())
                .build();
    }

    @Test
    void subStepsOfAStiffBodyAreReportedWhileItNeedsThem() {
        World world =
                heard(
                        Balls.ball("Brake")
                                .velocity(1, 0, 0)
                                .effect(
                                        new Damping(
                                                new Vec3(300, 0, 0),
                                                Vec3.ZERO,
                                                Vec3.ZERO,
                                                Vec3.ZERO))
                                .build());

        world.advanceTimestep();

        assertThat(reports()).hasSize(1);
        assertThat(reports().getFirst().subSteps())
                .isPositive()
                .isEqualTo(world.statistics().subSteps());
        assertThat(reports().getFirst().heldPairs()).isZero();
    }

    @Test
    void aQuietWorldReportsNothing() {
        World world =
                heard(
                        Balls.ball("Hit").restitution(0.5).build(),
                        Balls.ball("Hitting").position(1.02, 0, 0).velocity(-1, 0, 0).build());

        world.advanceTimestep();
        world.advanceTimestep();

        assertThat(events).hasAtLeastOneElementOfType(WorldEvent.Collided.class);
        assertThat(reports()).isEmpty();
    }

    @Test
    void whoBeginsToListenLateHearsOfItsOwnStepsAlone() {
        World world = World.builder().add(floor()).add(box("Box", 0)).build();
        for (int step = 0; step < 10; step++) {
            world.advanceTimestep();
        }
        world.addListener(events::add);

        world.advanceTimestep();

        assertThat(reports())
                .containsExactly(new WorldEvent.StepReport(world.time(), 0, 1, 0, 0, 0, 0));
    }
}
