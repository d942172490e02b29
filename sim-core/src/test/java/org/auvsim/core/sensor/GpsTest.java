package org.auvsim.core.sensor;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import org.auvsim.core.entity.Current;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.world.World;
import org.auvsim.core.world.WorldBuilder;
import org.auvsim.core.world.WorldException;
import org.junit.jupiter.api.Test;

import java.util.List;

class GpsTest {
    private static final Datum MONTEREY = new Datum(36.6, -121.9, -33);

    /** Raises the surface by 0.3 m and does nothing else. */
    private record Swell(long id, String name) implements Current {
        @Override
        public Vec3 valueAt(Vec3 position, double time) {
            return Vec3.ZERO;
        }

        @Override
        public double elevation(double x, double y, double time) {
            return 0.3;
        }
    }

    private static Gps gps(VectorErrors errors) {
        return new Gps("gps", new Vec3(0, 0, 0.5), 0, 0.1, errors, Sampling.at(20));
    }

    private static WorldBuilder at(double z, Gps gps) {
        return World.builder().datum(MONTEREY).add(Bench.ball(gps).position(1000, 2000, z).build());
    }

    @Test
    void itTellsWhereItsAntennaIs() {
        GpsReading reading = Bench.reading(at(0, gps(VectorErrors.NONE)).build(), GpsReading.class);

        GeodeticPosition expected = MONTEREY.toGeodetic(new Vec3(1000, 2000, 0.5));
        assertThat(reading)
                .isEqualTo(
                        new GpsReading(
                                expected.latitude(), expected.longitude(), expected.altitude()));
        // 1 km east and 2 km north: 1 / (111.4 km cos 36.6 deg) and 2 / 111.0 km
        assertThat(reading.longitude()).isCloseTo(-121.9 + 0.011181, within(5e-6));
        assertThat(reading.latitude()).isCloseTo(36.6 + 0.018022, within(5e-6));
    }

    /** Cannot be asked before it is prepared. */
    private record Unprepared(long id, String name) implements Current {
        @Override
        public Current prepared() {
            return new Swell(id, name);
        }

        @Override
        public Vec3 valueAt(Vec3 position, double time) {
            throw new IllegalStateException("not prepared");
        }

        @Override
        public double elevation(double x, double y, double time) {
            throw new IllegalStateException("not prepared");
        }
    }

    @Test
    void sensorsMeetCurrentsAsTheWorldPreparedThem() {
        World world = at(-0.25, gps(VectorErrors.NONE)).add(new Unprepared(5, "Sea")).build();

        assertThat(Bench.readings(world, GpsReading.class, 1)).hasSize(20);
    }

    @Test
    void belowTheSurfaceItReadsNothing() {
        assertThat(readings(at(-0.55, gps(VectorErrors.NONE)))).hasSize(20);
        assertThat(readings(at(-0.65, gps(VectorErrors.NONE)))).isEmpty();
    }

    @Test
    void aWaveOverItsAntennaSilencesIt() {
        Swell swell = new Swell(9, "swell");

        assertThat(readings(at(-0.35, gps(VectorErrors.NONE)).add(swell))).isEmpty();
        assertThat(readings(at(-0.25, gps(VectorErrors.NONE)).add(swell))).hasSize(20);
    }

    private static List<GpsReading> readings(WorldBuilder world) {
        return Bench.readings(world.build(), GpsReading.class, 1);
    }

    @Test
    void itsErrorsAreInMetresEastNorthAndUp() {
        VectorErrors errors =
                new VectorErrors(new Vec3(1.5, 2.5, 4), new Vec3(3, -2, 1), Vec3.ZERO);

        List<Vec3> places =
                Bench.readings(at(0, gps(errors)).build(), GpsReading.class, 200).stream()
                        .map(r -> new GeodeticPosition(r.latitude(), r.longitude(), r.altitude()))
                        .map(MONTEREY::toWorld)
                        .toList();

        int n = places.size();
        assertThat(Bench.mean(places, Vec3::x)).isCloseTo(1003, within(5 * 1.5 / Math.sqrt(n)));
        assertThat(Bench.mean(places, Vec3::y)).isCloseTo(1998, within(5 * 2.5 / Math.sqrt(n)));
        assertThat(Bench.mean(places, Vec3::z)).isCloseTo(1.5, within(5 * 4 / Math.sqrt(n)));
        double spread = 5 * Math.sqrt(2.0 / n);
        assertThat(Bench.variance(places, Vec3::x) / 2.25).isCloseTo(1, within(spread));
        assertThat(Bench.variance(places, Vec3::y) / 6.25).isCloseTo(1, within(spread));
        assertThat(Bench.variance(places, Vec3::z) / 16).isCloseTo(1, within(spread));
    }

    @Test
    void aWorldThatIsNowhereHasNoGps() {
        WorldBuilder nowhere = World.builder().add(Bench.ball(gps(VectorErrors.NONE)).build());

        assertThatThrownBy(nowhere::build)
                .isInstanceOf(WorldException.class)
                .hasMessage(
                        "the sensor 'gps' of 'Ball' is a GPS, which needs a datum; add <datum"
                                + " latitude longitude/>");
    }
}
