package org.auvsim.core.field;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;
import static org.auvsim.core.math.Near.assertNear;

import org.auvsim.core.entity.Block;
import org.auvsim.core.entity.Current;
import org.auvsim.core.math.Draws;
import org.auvsim.core.math.Vec3;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

import java.util.List;
import java.util.OptionalDouble;
import java.util.stream.Stream;

class WavesTest {
    private static final AiryWave DEEP =
            new AiryWave(1, "swell", 0.8, 6, 0.4, 0.3, OptionalDouble.empty(), 0);
    private static final AiryWave SHALLOW =
            new AiryWave(2, "surf", 0.3, 7, -2, 0.1, OptionalDouble.of(4), 1);

    private static List<Vec3> places(long seed) {
        Draws draws = new Draws(seed);
        return Stream.generate(() -> draws.vector(8)).limit(60).toList();
    }

    @ParameterizedTest(name = "seed {0}")
    @ValueSource(longs = {1, 2, 3})
    void wavesKnowTheirDerivatives(long seed) {
        Flows.assertExact(DEEP, places(seed), 12.3, 1e-7);
        Flows.assertExact(SHALLOW, places(seed), 12.3, 1e-7);
        Flows.assertExact(sea(3.3, 20), places(seed), 12.3, 1e-7);
    }

    @ParameterizedTest(name = "seed {0}")
    @ValueSource(longs = {1, 2, 3})
    void waterUnderWavesKeepsItsVolumeAndDoesNotRotate(long seed) {
        for (Current wave : List.of(DEEP, SHALLOW, sea(1, 20))) {
            Block block = Flows.at(places(seed), 5);
            wave.prepared().addTo(block);
            for (int i = 0; i < block.count; i++) {
                double z = places(seed).get(i).z();
                if (z < 0 && z > -3) {
                    assertThat(Flows.divergence(block, i)).isCloseTo(0, within(1e-14));
                    assertThat(block.flow[5][i]).isCloseTo(block.flow[9][i], within(1e-14));
                    assertThat(block.flow[4][i]).isCloseTo(block.flow[6][i], within(1e-14));
                }
            }
        }
    }

    /** omega^2 = g k tanh(k h), and its limits for deep and shallow water. */
    @ParameterizedTest
    @CsvSource({"2, 1000", "8, 30", "8, 4", "15, 2", "200, 5", "3, 0.01", "0.5, 3"})
    void theDispersionRelationHolds(double period, double depth) {
        double omega = 2 * Math.PI / period;
        double k = Dispersion.wavenumber(omega, depth);
        double g = 9.80665;
        assertThat(g * k * StrictMath.tanh(k * depth) / (omega * omega))
                .isCloseTo(1, within(1e-13));
        assertThat(k).isGreaterThanOrEqualTo(omega * omega / g * (1 - 1e-13));
        assertThat(Dispersion.wavenumber(omega, Double.POSITIVE_INFINITY))
                .isEqualTo(omega * omega / g);
        assertThat(Dispersion.wavenumber(1e-4, 10))
                .isCloseTo(1e-4 / Math.sqrt(g * 10), within(1e-12));
    }

    /** At the surface the water rises as the surface does, and at the ground it does not rise. */
    @ParameterizedTest
    @ValueSource(doubles = {0, 1.3, 4.4})
    void theWaterFollowsTheSurfaceAndTheGround(double time) {
        double h = 1e-5;
        double rise =
                (SHALLOW.elevation(3, 2, time + h) - SHALLOW.elevation(3, 2, time - h)) / (2 * h);
        assertThat(SHALLOW.valueAt(new Vec3(3, 2, 1), time).z()).isCloseTo(rise, within(1e-8));
        assertThat(SHALLOW.valueAt(new Vec3(3, 2, -3), time).z()).isCloseTo(0, within(1e-15));
        assertThat(SHALLOW.valueAt(new Vec3(3, 2, 9), time))
                .isEqualTo(SHALLOW.valueAt(new Vec3(3, 2, 1), time));
    }

    /** Bernoulli at the still level, linearised: du/dt = -g d(elevation)/dx. */
    @ParameterizedTest
    @ValueSource(doubles = {0, 1.3, 4.4})
    void theSlopeOfTheSurfaceDrivesTheWater(double time) {
        double h = 1e-5;
        Block block = Flows.at(List.of(new Vec3(3, 2, 1)), time);
        SHALLOW.prepared().addTo(block);
        double x =
                (SHALLOW.elevation(3 + h, 2, time) - SHALLOW.elevation(3 - h, 2, time)) / (2 * h);
        double y =
                (SHALLOW.elevation(3, 2 + h, time) - SHALLOW.elevation(3, 2 - h, time)) / (2 * h);
        assertThat(block.flow[0][0]).isCloseTo(-9.80665 * x, within(1e-8));
        assertThat(block.flow[1][0]).isCloseTo(-9.80665 * y, within(1e-8));
    }

    /** Deep water moves in circles of radius a exp(k z). */
    @Test
    void deepWaterMovesInCirclesThatShrinkWithDepth() {
        double k = 4 * Math.PI * Math.PI / 36 / 9.80665;
        double speed = 0.8 * 2 * Math.PI / 6 * StrictMath.exp(-5 * k);
        for (int t = 0; t < 6; t++) {
            assertThat(DEEP.valueAt(new Vec3(1, 1, -5), t).norm()).isCloseTo(speed, within(1e-12));
        }
        Vec3 crest = DEEP.valueAt(new Vec3(0, 0, -5), 0.3 / (2 * Math.PI / 6));
        assertNear(
                crest, new Vec3(StrictMath.cos(0.4), StrictMath.sin(0.4), 0).times(speed), 1e-12);
    }

    private static IrregularWaves sea(double gamma, int components) {
        return new IrregularWaves(
                3, "sea", 2, 8, gamma, 0.5, components, 42, OptionalDouble.empty(), 0);
    }

    /** Hs^2/16, at a place over three hours and 200 waves' frequencies. */
    @ParameterizedTest
    @ValueSource(doubles = {1, 3.3})
    void theSurfaceHasTheVarianceOfItsSignificantHeight(double gamma) {
        double sum = 0;
        int samples = 10_800;
        Current sea = sea(gamma, 200).prepared();
        for (int s = 0; s < samples; s++) {
            double raised = sea.elevation(3, -2, s);
            sum += raised * raised;
        }
        assertThat(sum / samples).isCloseTo(4.0 / 16, within(0.01));
    }

    /**
     * The mean period from one rise through still water to the next is 0.71 Tp for Pierson and
     * Moskowitz, 0.78 Tp for JONSWAP (DNV-RP-C205, section 3.5.5), and a little longer without the
     * waves of the highest frequencies.
     */
    @ParameterizedTest
    @CsvSource({"1, 0.71", "3.3, 0.78"})
    void theMeanPeriodIsThatOfTheSpectrum(double gamma, double share) {
        Current sea = sea(gamma, 200).prepared();
        int rises = 0;
        double before = sea.elevation(0, 0, 0);
        for (int s = 1; s < 40_000; s++) {
            double now = sea.elevation(0, 0, 0.25 * s);
            rises += before < 0 && now >= 0 ? 1 : 0;
            before = now;
        }
        assertThat(10_000.0 / rises / 8).isBetween(share, share + 0.03);
    }

    @Test
    void theSeaIsThatOfItsSeed() {
        Vec3 place = new Vec3(1, 2, -3);
        assertThat(sea(1, 10).valueAt(place, 5)).isEqualTo(sea(1, 10).valueAt(place, 5));
        IrregularWaves other =
                new IrregularWaves(3, "sea", 2, 8, 1, 0.5, 10, 43, OptionalDouble.empty(), 0);
        assertThat(other.valueAt(place, 5)).isNotEqualTo(sea(1, 10).valueAt(place, 5));
    }

    @Test
    void wavesThatCannotBeAreRefused() {
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new AiryWave(1, "w", 3, 4, 0, 0, OptionalDouble.empty(), 0))
                .withMessageContaining("the amplitude of wave 'w' must be 1.77")
                .withMessageContaining("as a steeper one breaks, but is 3.0 m");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new AiryWave(1, "w", 0.1, 4, 0, 0, OptionalDouble.of(-2), 0))
                .withMessageContaining("the depth of wave 'w' must be above 0 m");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> sea(0.5, 10))
                .withMessageContaining("the gamma of waves 'sea' must be 1.0 to 10.0");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> sea(1, 0))
                .withMessageContaining(
                        "the number of components of waves 'sea' must be 1.0 to 1000.0");
        assertThatIllegalArgumentException()
                .isThrownBy(
                        () ->
                                new IrregularWaves(
                                        1, "sea", 50, 6, 1, 0, 10, 7, OptionalDouble.empty(), 0))
                .withMessageContaining("the significant height of waves 'sea' must be 7.9")
                .withMessageContaining("but is 50.0 m");
    }
}
