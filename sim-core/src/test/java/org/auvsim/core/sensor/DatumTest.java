package org.auvsim.core.sensor;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import org.auvsim.core.math.Vec3;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.util.SplittableRandom;

class DatumTest {
    private static final double LATITUDE = 53 + 48 / 60.0 + 33.820 / 3600;
    private static final double LONGITUDE = 2 + 7 / 60.0 + 46.380 / 3600;

    private static double millimetres(double value) {
        return Math.round(value * 1000) / 1000.0;
    }

    /** IOGP Publication 373-7-2, methods 9602 and 9837: the published example, in millimetres. */
    @Test
    void thePublishedExampleOfEpsg() {
        GeodeticPosition place = new GeodeticPosition(LATITUDE, LONGITUDE, 73);

        Vec3 fixed = Wgs84.earthFixed(LATITUDE, LONGITUDE, 73);
        Vec3 local = new Datum(55, 5, 200).toWorld(place);

        assertThat(new Vec3(millimetres(fixed.x()), millimetres(fixed.y()), millimetres(fixed.z())))
                .isEqualTo(new Vec3(3771793.968, 140253.342, 5124304.349));
        assertThat(new Vec3(millimetres(local.x()), millimetres(local.y()), millimetres(local.z())))
                .isEqualTo(new Vec3(-189013.869, -128642.040, -4220.171));
    }

    @Test
    void thePublishedExampleOfEpsgBack() {
        GeodeticPosition place =
                new Datum(55, 5, 200).toGeodetic(new Vec3(-189013.869, -128642.040, -4220.171));

        assertThat(place.latitude()).isCloseTo(LATITUDE, within(1e-8));
        assertThat(place.longitude()).isCloseTo(LONGITUDE, within(1e-8));
        assertThat(place.altitude()).isCloseTo(73, within(1e-3));
    }

    @ParameterizedTest(name = "seed {0}")
    @ValueSource(longs = {1, 2, 3, 4, 5})
    void thereAndBackIsWhereItWas(long seed) {
        SplittableRandom random = new SplittableRandom(seed);
        for (int i = 0; i < 200; i++) {
            Datum datum =
                    new Datum(
                            random.nextDouble(-90, 90),
                            random.nextDouble(-180, 180),
                            random.nextDouble(-100, 3000));
            Vec3 point =
                    new Vec3(
                            random.nextDouble(-3e4, 3e4),
                            random.nextDouble(-3e4, 3e4),
                            random.nextDouble(-1e4, 1e4));

            assertThat(datum.toWorld(datum.toGeodetic(point)).distance(point)).isLessThan(1e-7);
        }
    }

    @Test
    void polesAndTheEquatorArePlacesToo() {
        for (double latitude : new double[] {-90, 0, 90}) {
            GeodeticPosition place = new Datum(latitude, 180, 12).toGeodetic(Vec3.ZERO);

            assertThat(place.latitude()).isCloseTo(latitude, within(1e-12));
            assertThat(place.altitude()).isCloseTo(12, within(1e-8));
        }
    }

    @Test
    void whatIsNowhereOnEarthIsRefused() {
        assertThatThrownBy(() -> new Datum(91, 0, 0))
                .hasMessage(
                        "the latitude of a datum must be -90.0 to 90.0 degrees, but is 91.0"
                                + " degrees");
        assertThatThrownBy(() -> new Datum(0, 181, 0)).hasMessageContaining("181.0");
        assertThatThrownBy(() -> new Datum(0, 0, Double.NaN)).hasMessageContaining("NaN");
    }
}
