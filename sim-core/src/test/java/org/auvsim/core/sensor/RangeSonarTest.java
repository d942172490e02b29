package org.auvsim.core.sensor;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.volume.Box;
import org.auvsim.core.volume.HalfSpace;
import org.auvsim.core.volume.Sphere;
import org.auvsim.core.volume.Volume;
import org.auvsim.core.world.World;
import org.auvsim.core.world.WorldBuilder;
import org.junit.jupiter.api.Test;

import java.util.List;

class RangeSonarTest {
    private static RangeSonar sonar(int beams, double fan, double least, double most, double rate) {
        return new RangeSonar(
                "sonar",
                new Vec3(0.5, 0, 0),
                Quat.IDENTITY,
                beams,
                fan,
                least,
                most,
                ScalarErrors.NONE,
                Sampling.at(rate));
    }

    private static WorldBuilder world(RangeSonar sonar) {
        return World.builder().add(Bench.ball(sonar).build());
    }

    private static WorldObjectDefinition target(String name, Volume volume, double x, double y) {
        return WorldObjectDefinition.named(name).mass(5).volume(volume).position(x, y, 0).build();
    }

    private static List<RangeReading.Echo> echoes(WorldBuilder world) {
        return Bench.reading(world.build(), RangeReading.class).echo();
    }

    @Test
    void oneBeamMeetsTheNearestBody() {
        WorldBuilder world =
                world(sonar(1, 0, 0, 50, 20))
                        .add(target("far", new Sphere(1), 20, 0))
                        .add(target("near", new Box(new Vec3(2, 2, 2)), 10, 0.5))
                        .add(target("beside", new Sphere(1), 5, 3));

        assertThat(echoes(world)).containsExactly(new RangeReading.Echo(0, 8.5));
    }

    @Test
    void nothingWithinTheRangeIsNoEcho() {
        assertThat(echoes(world(sonar(1, 0, 0, 8, 20)).add(target("far", new Sphere(1), 20, 0))))
                .isEmpty();
        assertThat(echoes(world(sonar(1, 0, 3, 8, 20)).add(target("near", new Sphere(1), 3, 0))))
                .isEmpty();
    }

    /** Beams at -30, -15, 0, 15 and 30 degrees on a wall 10 m ahead of the sonar. */
    @Test
    void aFanMeetsAWallFartherAwayTheMoreItsBeamsLean() {
        WorldBuilder world =
                world(sonar(5, Math.PI / 3, 0, 50, 20))
                        .add(
                                WorldObjectDefinition.named("Wall")
                                        .fixed()
                                        .volume(new HalfSpace())
                                        .position(10.5, 0, 0)
                                        .orientation(Bench.pitch(-Math.PI / 2))
                                        .build());

        List<RangeReading.Echo> echoes = echoes(world);

        assertThat(echoes).hasSize(5);
        for (RangeReading.Echo echo : echoes) {
            double lean = Math.toRadians(15 * (echo.beam() - 2));
            assertThat(echo.distance()).isCloseTo(10 / Math.cos(lean), within(1e-9));
        }
    }

    @Test
    void beamsAreNumberedFromStarboard() {
        WorldBuilder world =
                world(sonar(3, Math.PI / 2, 0, 50, 20))
                        .add(target("port", new Sphere(1), 10.5, 10));

        assertThat(echoes(world)).extracting(RangeReading.Echo::beam).containsExactly(2);
    }

    /** A ball that flies away at 3 m/s, seen at instants within the steps. */
    @Test
    void whatMovesIsSeenWhereItIsAtTheInstantOfTheMeasurement() {
        World world =
                world(sonar(1, 0, 0, 50, 60))
                        .add(
                                WorldObjectDefinition.named("Fish")
                                        .mass(1)
                                        .volume(new Sphere(0.5))
                                        .position(6, 0, 0)
                                        .velocity(3, 0, 0)
                                        .build())
                        .build();

        List<RangeReading> readings = Bench.readings(world, RangeReading.class, 1);

        assertThat(readings).hasSize(60);
        for (int k = 1; k <= 60; k++) {
            assertThat(readings.get(k - 1).echo().getFirst().distance())
                    .isCloseTo(5 + 3 * k / 60.0, within(1e-9));
        }
    }

    @Test
    void itsErrorsAreAsStated() {
        RangeSonar noisy =
                new RangeSonar(
                        "sonar",
                        Vec3.ZERO,
                        Quat.IDENTITY,
                        1,
                        0,
                        0,
                        50,
                        new ScalarErrors(0.05, -0.1, 0),
                        Sampling.at(20));
        World world = world(noisy).add(target("wall", new Sphere(1), 9, 0)).build();

        List<RangeReading> readings = Bench.readings(world, RangeReading.class, 200);

        int n = readings.size();
        assertThat(Bench.mean(readings, r -> r.echo().getFirst().distance()))
                .isCloseTo(7.9, within(5 * 0.05 / Math.sqrt(n)));
        assertThat(Bench.variance(readings, r -> r.echo().getFirst().distance()) / 0.0025)
                .isCloseTo(1, within(5 * Math.sqrt(2.0 / n)));
    }

    @Test
    void whatMakesNoSenseIsRefused() {
        assertThatThrownBy(() -> sonar(0, 0, 0, 1, 1))
                .hasMessageStartingWith("the beams of range-sonar 'sonar' must be 1.0 to 512.0");
        assertThatThrownBy(() -> sonar(2, 4, 0, 1, 1)).hasMessageContaining("the fan of");
        assertThatThrownBy(() -> sonar(1, 0, 2, 1, 1)).hasMessageContaining("minimum-range");
    }
}
