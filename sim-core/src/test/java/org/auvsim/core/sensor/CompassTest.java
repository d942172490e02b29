package org.auvsim.core.sensor;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.auvsim.core.math.Quat;
import org.auvsim.core.world.World;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import java.util.List;

class CompassTest {
    private static Compass compass(double declination, ScalarErrors errors) {
        return new Compass("compass", Quat.IDENTITY, declination, errors, Sampling.at(20));
    }

    private static World pointing(Quat orientation, Compass compass) {
        return World.builder().add(Bench.ball(compass).orientation(orientation).build()).build();
    }

    /** Yaw turns from east to north, a heading from north to east. */
    @ParameterizedTest
    @CsvSource({"0, 90", "90, 0", "180, 270", "-90, 180", "60, 30", "100, 350"})
    void headingsAreClockwiseFromNorth(double yaw, double heading) {
        World world = pointing(Bench.yaw(Math.toRadians(yaw)), compass(0, ScalarErrors.NONE));

        assertThat(Bench.reading(world, CompassReading.class).heading())
                .isCloseTo(Math.toRadians(heading), within(1e-12));
    }

    @Test
    void itIsKeptLevel() {
        Quat nosedown = Bench.yaw(Math.toRadians(60)).times(Bench.pitch(1.2));
        World world = pointing(nosedown, compass(0, ScalarErrors.NONE));

        assertThat(Bench.reading(world, CompassReading.class).heading())
                .isCloseTo(Math.toRadians(30), within(1e-12));
    }

    @Test
    void magneticNorthIsEastOfTrueNorthByTheDeclination() {
        World world = pointing(Bench.yaw(Math.toRadians(80)), compass(0.3, ScalarErrors.NONE));

        assertThat(Bench.reading(world, CompassReading.class).heading())
                .isCloseTo(2 * Math.PI + Math.toRadians(10) - 0.3, within(1e-12));
    }

    @Test
    void itsNoiseStaysOnTheCircle() {
        World world = pointing(Bench.yaw(Math.PI / 2), compass(0, new ScalarErrors(0.02, 0, 0)));

        List<CompassReading> readings = Bench.readings(world, CompassReading.class, 200);

        assertThat(readings).allMatch(r -> r.heading() >= 0 && r.heading() < 2 * Math.PI);
        assertThat(readings.stream().filter(r -> r.heading() > Math.PI)).isNotEmpty();
        double north = Bench.mean(readings, r -> Math.IEEEremainder(r.heading(), 2 * Math.PI));
        assertThat(north).isCloseTo(0, within(5 * 0.02 / Math.sqrt(readings.size())));
        assertThat(Bench.variance(readings, r -> Math.IEEEremainder(r.heading(), 2 * Math.PI)))
                .isCloseTo(4e-4, within(5 * 4e-4 * Math.sqrt(2.0 / readings.size())));
    }

    @Test
    void itMayBeMountedAskew() {
        Compass aft = new Compass("c", Bench.yaw(Math.PI), 0, ScalarErrors.NONE, Sampling.at(20));
        World world = pointing(Bench.yaw(Math.PI / 2), aft);

        assertThat(Bench.reading(world, CompassReading.class).heading())
                .isCloseTo(Math.PI, within(1e-12));
    }
}
