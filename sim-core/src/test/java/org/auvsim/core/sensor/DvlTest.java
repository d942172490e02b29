package org.auvsim.core.sensor;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.core.field.UniformCurrent;
import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.volume.HalfSpace;
import org.auvsim.core.volume.Sphere;
import org.auvsim.core.world.World;
import org.auvsim.core.world.WorldBuilder;
import org.junit.jupiter.api.Test;

import java.util.List;
import java.util.OptionalDouble;

class DvlTest {
    private static final double BEAM = Math.PI / 6;

    private static Dvl dvl(double range, double scale, VectorErrors errors, ScalarErrors altitude) {
        return new Dvl(
                "dvl",
                new Vec3(0, 0, -0.5),
                Quat.IDENTITY,
                BEAM,
                range,
                scale,
                errors,
                altitude,
                Sampling.at(20));
    }

    private static Dvl exact(double range) {
        return dvl(range, 1, VectorErrors.NONE, ScalarErrors.NONE);
    }

    /** Over a bottom 20 m below the origin, in water that drifts east. */
    private static WorldBuilder sea(WorldObjectDefinition.Builder vehicle) {
        return World.builder()
                .add(new UniformCurrent(9, "Drift", new Vec3(0.4, 0, 0)))
                .add(
                        WorldObjectDefinition.named("Bottom")
                                .id(2)
                                .fixed()
                                .volume(new HalfSpace())
                                .position(0, 0, -20)
                                .build())
                .add(vehicle.build());
    }

    private static DvlReading reading(WorldObjectDefinition.Builder vehicle) {
        return Bench.reading(sea(vehicle).build(), DvlReading.class);
    }

    @Test
    void overTheBottomItTellsItsVelocityOverGroundAndItsAltitude() {
        DvlReading reading =
                reading(
                        Bench.ball(exact(30))
                                .orientation(Bench.yaw(Math.PI / 2))
                                .velocity(0, 1.5, 0)
                                .position(0, 0, -5));

        assertThat(reading.reference()).isEqualTo(DvlReference.BOTTOM);
        assertThat(reading.velocity().distance(new Vec3(1.5, 0, 0))).isLessThan(1e-12);
        assertThat(reading.altitude().orElseThrow()).isCloseTo(14.5, within(1e-12));
    }

    @Test
    void outOfRangeOfTheBottomItTellsItsVelocityThroughTheWater() {
        double beam = 14.5 / Math.cos(BEAM);
        WorldObjectDefinition.Builder vehicle =
                Bench.ball(exact(beam - 0.01)).velocity(1.5, 0, 0).position(0, 0, -5);

        DvlReading reading = reading(vehicle);

        assertThat(reading.reference()).isEqualTo(DvlReference.WATER);
        assertThat(reading.velocity().distance(new Vec3(1.1, 0, 0))).isLessThan(1e-12);
        assertThat(reading.altitude()).isEqualTo(OptionalDouble.empty());
        assertThat(reading(Bench.ball(exact(beam + 0.01)).position(0, 0, -5)).reference())
                .isEqualTo(DvlReference.BOTTOM);
    }

    /** Rolled by 10 degrees two beams are at 30 - 10 degrees from the vertical, two at 30 + 10. */
    @Test
    void aRolledOneTellsTheMeanOfItsBeams() {
        Quat roll = Quat.ofAxisAngle(new Vec3(1, 0, 0), Math.toRadians(10));
        DvlReading reading = reading(Bench.ball(exact(60)).orientation(roll).position(0, 0, 0));

        double height = 20 - 0.5 * Math.cos(Math.toRadians(10));
        double lean = Math.sin(BEAM) * Math.sqrt(0.5);
        double ten = Math.toRadians(10);
        double up = Math.cos(BEAM) * Math.cos(ten);
        double near = height / (up + lean * Math.sin(ten));
        double far = height / (up - lean * Math.sin(ten));
        assertThat(reading.altitude().orElseThrow())
                .isCloseTo((near + far) / 2 * Math.cos(BEAM), within(1e-12));
    }

    @Test
    void whatSwimsBelowIsNoBottom() {
        World world =
                sea(Bench.ball(exact(10)))
                        .add(
                                WorldObjectDefinition.named("Whale")
                                        .mass(1e5)
                                        .volume(new Sphere(4))
                                        .position(0, 0, -6)
                                        .build())
                        .build();

        assertThat(Bench.reading(world, DvlReading.class).reference())
                .isEqualTo(DvlReference.WATER);
    }

    @Test
    void aTurningVehicleMovesItsLog() {
        DvlReading reading = reading(Bench.ball(exact(60)).angularVelocity(0, 0.2, 0));

        // 0.5 m below the origin, turning nose down: backward, seen in its axes
        assertThat(reading.velocity().distance(new Vec3(-0.1, 0, 0))).isLessThan(1e-7);
    }

    @Test
    void itsErrorsAreAsStated() {
        VectorErrors errors =
                new VectorErrors(new Vec3(0.01, 0.01, 0.005), new Vec3(0, 0.03, 0), Vec3.ZERO);
        Dvl dvl = dvl(60, 1.02, errors, new ScalarErrors(0.1, 0.5, 0));
        World world = sea(Bench.ball(dvl).velocity(1, 0, 0)).build();

        List<DvlReading> readings = Bench.readings(world, DvlReading.class, 200);

        int n = readings.size();
        double spread = 5 * Math.sqrt(2.0 / n);
        assertThat(Bench.mean(readings, r -> r.velocity().x()))
                .isCloseTo(1.02, within(5 * 0.01 / Math.sqrt(n)));
        assertThat(Bench.mean(readings, r -> r.velocity().y()))
                .isCloseTo(0.03, within(5 * 0.01 / Math.sqrt(n)));
        assertThat(Bench.mean(readings, r -> r.altitude().orElseThrow()))
                .isCloseTo(20, within(5 * 0.1 / Math.sqrt(n)));
        assertThat(Bench.variance(readings, r -> r.velocity().z()) / 2.5e-5)
                .isCloseTo(1, within(spread));
        assertThat(Bench.variance(readings, r -> r.altitude().orElseThrow()) / 0.01)
                .isCloseTo(1, within(spread));
    }

    @Test
    void whatMakesNoSenseIsRefused() {
        assertThatThrownBy(() -> exact(0))
                .hasMessage("the range of dvl 'dvl' must be above 0 m and finite, but is 0.0 m");
    }
}
