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
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;

import java.util.List;
import java.util.stream.Stream;

/** Currents with a formula: shear, vortex, oscillation. */
class CurrentsTest {
    private static final Current SHEAR =
            new ShearCurrent(1, "shear", new Vec3(0.5, 0.1, 0), -5, new Vec3(0.02, -0.03, 0));
    private static final Current TIDE =
            new OscillatingCurrent(
                    2, "tide", new Vec3(0.1, 0, 0), new Vec3(0.4, 0.2, -0.1), 20, 0.7);

    private static List<Vec3> places(long seed) {
        Draws draws = new Draws(seed);
        return Stream.generate(() -> draws.vector(4)).limit(50).toList();
    }

    @ParameterizedTest(name = "seed {0}")
    @ValueSource(longs = {1, 2, 3})
    void shearAndTideKnowTheirDerivatives(long seed) {
        Flows.assertExact(SHEAR, places(seed), 3, 1e-11);
        Flows.assertExact(TIDE, places(seed), 3, 1e-9);
    }

    @ParameterizedTest
    @EnumSource(VortexProfile.class)
    void aVortexKnowsItsDerivativesAndKeepsItsVolume(VortexProfile profile) {
        Current vortex = new VortexCurrent(3, "vortex", 0.5, -0.3, 6, 1.5, profile);
        Flows.assertExact(vortex, places(4), 0, 1e-7);
        Block block = Flows.at(places(4), 0);
        vortex.addTo(block);
        for (int i = 0; i < block.count; i++) {
            assertThat(Flows.divergence(block, i)).isCloseTo(0, within(1e-15));
        }
    }

    /**
     * The circulation around any circle is G (1 - exp(-r^2/a^2)), G outside Rankine's core, or G
     * r^2/(r^2 + a^2).
     */
    @ParameterizedTest
    @ValueSource(doubles = {0.001, 0.3, 1, 2.5, 40})
    void aVortexHasItsCirculation(double r) {
        double smooth = 6 * -StrictMath.expm1(-r * r / 2.25);
        double solid = 6 * Math.min(1, r * r / 2.25);
        double slow = 6 * r * r / (r * r + 2.25);
        assertThat(circulation(VortexProfile.LAMB_OSEEN, r)).isCloseTo(smooth, within(1e-12));
        assertThat(circulation(VortexProfile.RANKINE, r)).isCloseTo(solid, within(1e-12));
        assertThat(circulation(VortexProfile.KAUFMANN, r)).isCloseTo(slow, within(1e-12));
    }

    private static double circulation(VortexProfile profile, double r) {
        Current vortex = new VortexCurrent(3, "vortex", 2, 1, 6, 1.5, profile);
        double sum = 0;
        for (int k = 0; k < 12; k++) {
            double angle = k * Math.PI / 6;
            Vec3 way = new Vec3(StrictMath.cos(angle), StrictMath.sin(angle), 0);
            Vec3 u = vortex.valueAt(new Vec3(2, 1, 7).plus(way.times(r)), 0);
            assertThat(u.dot(way)).isCloseTo(0, within(1e-12));
            sum += u.dot(new Vec3(-way.y(), way.x(), 0));
        }
        return sum / 12 * 2 * Math.PI * r;
    }

    @Test
    void shearIsStatedAtItsHeight() {
        assertNear(SHEAR.valueAt(new Vec3(9, 9, -5), 1), new Vec3(0.5, 0.1, 0), 1e-15);
        assertNear(SHEAR.valueAt(new Vec3(9, 9, -15), 1), new Vec3(0.3, 0.4, 0), 1e-15);
    }

    @Test
    void aTideComesBackAfterItsPeriod() {
        Vec3 place = new Vec3(1, 2, 3);
        assertNear(TIDE.valueAt(place, 3), TIDE.valueAt(place, 23), 1e-15);
        assertNear(
                TIDE.valueAt(place, 3).plus(TIDE.valueAt(place, 13)), new Vec3(0.2, 0, 0), 1e-15);
        assertNear(
                TIDE.valueAt(place, 0),
                new Vec3(0.1, 0, 0).plus(new Vec3(0.4, 0.2, -0.1).times(StrictMath.sin(0.7))),
                1e-15);
    }

    @Test
    void numbersThatMeanNothingAreRefused() {
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new ShearCurrent(1, "s", Vec3.ZERO, 0, new Vec3(0, 0, 0.1)))
                .withMessage(
                        "the shear of current 's' must be horizontal, as water keeps its volume,"
                                + " but is (0.0, 0.0, 0.1) 1/s");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new OscillatingCurrent(1, "o", Vec3.ZERO, Vec3.ZERO, 0, 0))
                .withMessageContaining("the period of current 'o' must be above 0 s");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new VortexCurrent(1, "v", 0, 0, 1, -1, VortexProfile.RANKINE))
                .withMessageContaining("the core radius of current 'v' must be above 0 m");
    }
}
