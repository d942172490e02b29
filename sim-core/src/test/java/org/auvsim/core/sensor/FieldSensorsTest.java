package org.auvsim.core.sensor;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.auvsim.core.entity.MagneticField;
import org.auvsim.core.entity.TemperatureField;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.world.World;
import org.auvsim.core.world.WorldBuilder;
import org.junit.jupiter.api.Test;

import java.util.List;

/** What a magnetometer and a thermometer read of the world's fields. */
class FieldSensorsTest {
    /** A field that differs from place to place and from time to time. */
    private record Wedge(long id, String name, Vec3 base) implements MagneticField {
        @Override
        public Vec3 valueAt(Vec3 position, double time) {
            return base.plus(new Vec3(0, 1e-6 * position.x(), 1e-6 * time));
        }
    }

    /** Water that is colder below. */
    private record Layer(long id, String name, double surface, double lapse)
            implements TemperatureField {
        @Override
        public Double valueAt(Vec3 position, double time) {
            return surface + lapse * position.z();
        }
    }

    private static WorldBuilder world(Sensor sensor) {
        return World.builder()
                .add(
                        Bench.ball(sensor)
                                .position(10, 0, -4)
                                .orientation(Bench.yaw(Math.PI / 2))
                                .build());
    }

    private static Magnetometer magnetometer(VectorErrors errors) {
        return new Magnetometer("m", new Vec3(0, -2, 0), Bench.pitch(0), errors, Sampling.at(20));
    }

    @Test
    void fieldsAddUpAtTheSensorsPlaceAndAreSeenInItsAxes() {
        World world =
                world(magnetometer(VectorErrors.NONE))
                        .add(new Wedge(5, "Earth", new Vec3(2e-5, 0, -4e-5)))
                        .add(new Wedge(6, "Wreck", new Vec3(1e-5, 0, 0)))
                        .build();

        Vec3 field = Bench.reading(world, MagnetometerReading.class).field();

        // at x = 12 m: 3e-5 east, 2.4e-5 north; the body looks north
        Vec3 expected = new Vec3(2.4e-5, -3e-5, -4e-5 + 2 * 0.05e-6);
        assertThat(field.distance(expected)).isLessThan(1e-18);
    }

    @Test
    void aMagnetometersErrorsAreAsStated() {
        VectorErrors errors =
                new VectorErrors(new Vec3(1e-7, 2e-7, 3e-7), new Vec3(0, 1e-6, 0), Vec3.ZERO);
        World world = world(magnetometer(errors)).build();

        List<MagnetometerReading> readings = Bench.readings(world, MagnetometerReading.class, 250);

        int n = readings.size();
        double spread = 5 * Math.sqrt(2.0 / n);
        assertThat(Bench.variance(readings, r -> r.field().x()) / 1e-14)
                .isCloseTo(1, within(spread));
        assertThat(Bench.variance(readings, r -> r.field().y()) / 4e-14)
                .isCloseTo(1, within(spread));
        assertThat(Bench.variance(readings, r -> r.field().z()) / 9e-14)
                .isCloseTo(1, within(spread));
        assertThat(Bench.mean(readings, r -> r.field().y()))
                .isCloseTo(1e-6, within(5 * 2e-7 / Math.sqrt(n)));
    }

    @Test
    void aThermometerReadsTheWatersTemperatureAtItsPlace() {
        Thermometer below =
                new Thermometer(
                        "t", new Vec3(0, 0, -1), new ScalarErrors(0, 0.5, 0), Sampling.at(20));
        World world = world(below).add(new Layer(5, "Summer", 18, 0.8)).build();

        assertThat(Bench.reading(world, ThermometerReading.class).temperature())
                .isCloseTo(14.5, within(1e-12));
    }

    @Test
    void aThermometersErrorsAreAsStated() {
        ScalarErrors errors = new ScalarErrors(0.02, -0.3, 0);
        World world =
                world(new Thermometer("t", Vec3.ZERO, errors, Sampling.at(20)))
                        .add(new Layer(5, "Winter", 6, 0))
                        .build();

        List<ThermometerReading> readings = Bench.readings(world, ThermometerReading.class, 250);

        int n = readings.size();
        assertThat(n).isEqualTo(5000);
        assertThat(Bench.variance(readings, ThermometerReading::temperature) / 4e-4)
                .isCloseTo(1, within(5 * Math.sqrt(2.0 / n)));
        assertThat(Bench.mean(readings, ThermometerReading::temperature))
                .isCloseTo(6 - 0.3, within(5 * 0.02 / Math.sqrt(n)));
    }

    @Test
    void whereThereIsNoTemperatureAThermometerReadsNothing() {
        Thermometer thermometer =
                new Thermometer("t", Vec3.ZERO, ScalarErrors.NONE, Sampling.at(20));

        assertThat(Bench.readings(world(thermometer).build(), ThermometerReading.class, 1))
                .isEmpty();
    }
}
