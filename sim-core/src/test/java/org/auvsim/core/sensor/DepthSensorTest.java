package org.auvsim.core.sensor;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import org.auvsim.core.math.Vec3;
import org.auvsim.core.world.World;
import org.junit.jupiter.api.Test;

import java.util.List;

class DepthSensorTest {
    private static DepthSensor sensor(Vec3 at, double calibration, ScalarErrors errors) {
        return new DepthSensor("depth", at, 2, 1025, calibration, errors, Sampling.at(20));
    }

    private static double depth(double z, double pitch, DepthSensor sensor) {
        World world =
                World.builder()
                        .add(
                                Bench.ball(sensor)
                                        .position(5, 6, z)
                                        .orientation(Bench.pitch(pitch))
                                        .build())
                        .build();
        return Bench.reading(world, DepthReading.class).depth();
    }

    @Test
    void itIsBelowTheSurfaceWhereItSitsInTheBody() {
        DepthSensor inTheNose = sensor(new Vec3(1, 0, 0), 1025, ScalarErrors.NONE);

        assertThat(depth(-3, 0, inTheNose)).isEqualTo(5);
        assertThat(depth(-3, Math.PI / 6, inTheNose)).isCloseTo(5.5, within(1e-12));
        assertThat(depth(2.5, 0, inTheNose)).isZero();
    }

    @Test
    void waterOfAnotherDensityThanCalibratedForScalesTheDepth() {
        DepthSensor forFreshWater = sensor(Vec3.ZERO, 1000, ScalarErrors.NONE);

        assertThat(depth(-8, 0, forFreshWater)).isCloseTo(10.25, within(1e-12));
    }

    @Test
    void itsErrorsAreAsStated() {
        ScalarErrors errors = new ScalarErrors(0.05, 0.2, 0);
        World world = Bench.world(sensor(new Vec3(0, 0, -1), 1025, errors));

        List<DepthReading> readings = Bench.readings(world, DepthReading.class, 500);

        int n = readings.size();
        assertThat(n).isEqualTo(10_000);
        assertThat(Bench.mean(readings, DepthReading::depth))
                .isCloseTo(3.2, within(5 * 0.05 / Math.sqrt(n)));
        assertThat(Bench.variance(readings, DepthReading::depth))
                .isCloseTo(0.0025, within(5 * 0.0025 * Math.sqrt(2.0 / n)));
    }

    /** Over time t a drift d gains the variance d^2 t, which 400 sensors show to 5 sqrt(2/400). */
    @Test
    void theVarianceOfItsDriftGrowsWithTime() {
        int sensors = 400;
        Sensor[] all = new Sensor[sensors];
        for (int i = 0; i < sensors; i++) {
            all[i] =
                    new DepthSensor(
                            "depth" + i,
                            new Vec3(0, 0, -10),
                            0,
                            1025,
                            1025,
                            new ScalarErrors(0, 0, 0.03),
                            Sampling.at(0.05));
        }
        World world = World.builder().timeStep(1).add(Bench.ball(all).build()).build();

        List<DepthReading> readings = Bench.readings(world, DepthReading.class, 80);

        assertThat(readings).hasSize(4 * sensors);
        for (int k = 1; k <= 4; k++) {
            List<DepthReading> atOnce = readings.subList((k - 1) * sensors, k * sensors);
            double expected = 0.03 * 0.03 * 20 * k;
            assertThat(Bench.variance(atOnce, DepthReading::depth))
                    .isCloseTo(expected, within(5 * expected * Math.sqrt(2.0 / sensors)));
        }
    }

    @Test
    void whatMakesNoSenseIsRefused() {
        assertThatThrownBy(() -> sensor(Vec3.ZERO, 0, ScalarErrors.NONE))
                .hasMessage(
                        "the calibration-density of depth-sensor 'depth' must be above 0 kg/m^3 and"
                                + " finite, but is 0.0 kg/m^3");
        assertThatThrownBy(() -> sensor(new Vec3(0, 0, Double.NaN), 1, ScalarErrors.NONE))
                .hasMessageContaining("position of depth-sensor 'depth' must be finite, but");
        assertThatThrownBy(() -> new ScalarErrors(-1, 0, 0))
                .hasMessage("the deviation of a sensor must be 0 or more and finite, but is -1.0");
        assertThatThrownBy(() -> new ScalarErrors(0, Double.NaN, 0))
                .hasMessage("the bias of a sensor must be finite, but is NaN");
    }
}
