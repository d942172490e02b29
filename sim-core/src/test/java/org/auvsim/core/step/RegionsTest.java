package org.auvsim.core.step;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.core.effect.CentralForce;
import org.auvsim.core.entity.WorldObject;
import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.core.math.Draws;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.world.World;
import org.auvsim.core.world.WorldBuilder;
import org.auvsim.core.world.WorldEvent;
import org.junit.jupiter.api.Test;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;

/** Where regions are told apart nothing may come out differently. */
class RegionsTest {
    private static final int ENOUGH = 30_100;

    /** Boxes of 1 m with their lower corners along a line. */
    private static double[] boxes(IntStream places) {
        return places.mapToObj(x -> new double[] {x, 0, 0, x + 1, 1, 1})
                .flatMapToDouble(java.util.Arrays::stream)
                .toArray();
    }

    @Test
    void farClustersAreRegionsOfTheirOwn() {
        double[] box =
                boxes(IntStream.range(0, ENOUGH).map(i -> i % 2 == 0 ? i % 40 : 900 + i % 40));
        Regions regions = new Regions(box, ENOUGH);

        regions.find();

        assertThat(regions.areUsed()).isTrue();
        assertThat(regions.of(0)).isEqualTo(regions.of(38)).isNotEqualTo(regions.of(1));
        assertThat(regions.of(1)).isEqualTo(regions.of(39));
    }

    @Test
    void aBodyInTwoClustersMakesThemOne() {
        double[] box =
                boxes(IntStream.range(0, ENOUGH).map(i -> i % 2 == 0 ? i % 40 : 100 + i % 40));
        box[3] = 120;
        Regions regions = new Regions(box, ENOUGH);

        regions.find();

        assertThat(regions.of(2)).isEqualTo(regions.of(1));
    }

    @Test
    void whoComesIntoTheCellOfAnotherRegionIsNoticed() {
        double[] box =
                boxes(IntStream.range(0, ENOUGH).map(i -> i % 2 == 0 ? i % 40 : 100 + i % 40));
        Regions regions = new Regions(box, ENOUGH);
        regions.find();

        assertThat(regions.staysInside(0)).isTrue();
        box[3] = 60;
        assertThat(regions.staysInside(0)).isTrue();
        box[6] = 55;
        assertThat(regions.staysInside(1)).as("a cell that the other has claimed").isFalse();
    }

    @Test
    void fewBodiesAndSuchAsAreEverywhereHaveNoRegions() {
        double[] box = boxes(IntStream.range(0, ENOUGH).map(i -> 10 * i));
        Regions few = new Regions(box, 100);
        few.find();
        assertThat(few.areUsed()).isFalse();

        box[3] = Double.POSITIVE_INFINITY;
        Regions everywhere = new Regions(box, ENOUGH);
        everywhere.find();
        assertThat(everywhere.areUsed()).isFalse();
    }

    /** A cluster that falls together, far from all others. */
    private static List<WorldObjectDefinition> cluster(String name, int count, Vec3 middle) {
        Draws draws = new Draws(name.hashCode());
        List<WorldObjectDefinition> balls = new ArrayList<>();
        for (int i = 0; i < count; i++) {
            Vec3 cell =
                    new Vec3(i % 13 - 6, Math.floorDiv(i, 13) % 13 - 6, Math.floorDiv(i, 169) - 6);
            Vec3 target = middle.plus(draws.direction().times(6));
            balls.add(
                    Scene.ball(name + i, 0.5)
                            .position(middle.plus(cell.times(1.5)).plus(draws.vector(1e-3)))
                            .effect(new CentralForce(10, 0.1, target))
                            .build());
        }
        return balls;
    }

    private static World world(List<WorldObjectDefinition> bodies) {
        WorldBuilder builder = World.builder().stepper(EventStepper.standard());
        bodies.forEach(builder::add);
        return builder.build();
    }

    @Test
    void twoClustersMoveAsEachDoesAlone() {
        List<WorldObjectDefinition> one = cluster("One ", 15_100, Vec3.ZERO);
        List<WorldObjectDefinition> two = cluster("Two ", 15_100, new Vec3(400, 30, -7));
        List<WorldObjectDefinition> both = new ArrayList<>(one);
        both.addAll(two);
        World together = world(both);
        List<World> alone = List.of(world(one), world(two));
        List<Double> times = new ArrayList<>();
        together.addListener(
                e -> {
                    if (e instanceof WorldEvent.Collided collided) {
                        times.add(collided.collision().contact().time());
                    }
                });

        Ground.run(together, 1);
        alone.forEach(world -> Ground.run(world, 1));

        assertThat(together.statistics().collisions()).isGreaterThan(1_000);
        assertThat(times).isSorted();
        for (World world : alone) {
            for (WorldObject ball : world.objects()) {
                assertThat(together.object(ball.name()).position()).isEqualTo(ball.position());
                assertThat(together.object(ball.name()).velocity()).isEqualTo(ball.velocity());
            }
        }
    }

    /**
     * The ball is thrown aside so fast that it hits one of another region in the same frame, which
     * has been hit there before.
     */
    @Test
    void whoLeavesItsRegionInAFrameHitsWhatIsThere() {
        List<WorldObjectDefinition> few =
                List.of(
                        Scene.ball("Fast", 0.5).position(0, 0, 0).velocity(1000, 0, 0).build(),
                        Scene.ball("Hit", 0.5).position(5, -StrictMath.sqrt(0.5), 0).build(),
                        Scene.ball("Far", 0.5).position(24.5, 20.2, 0).build(),
                        Scene.ball("Local", 0.5)
                                .position(24.5, 20.2, 2.2)
                                .velocity(0, 0, -40)
                                .build());
        List<WorldObjectDefinition> many = new ArrayList<>(few);
        for (int i = 0; i < ENOUGH; i++) {
            many.add(Scene.ball("Idle " + i, 0.5).position(-100 - 2 * i, 0, 0).build());
        }
        World crowded = world(many);
        World alone = world(few);

        crowded.advanceTimestep();
        alone.advanceTimestep();

        assertThat(alone.statistics().collisions()).isGreaterThan(2);
        assertThat(crowded.statistics()).isEqualTo(alone.statistics());
        for (WorldObject ball : alone.objects()) {
            assertThat(crowded.object(ball.name()).position()).isEqualTo(ball.position());
            assertThat(crowded.object(ball.name()).velocity()).isEqualTo(ball.velocity());
        }
    }
}
