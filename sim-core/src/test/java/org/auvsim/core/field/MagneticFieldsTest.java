package org.auvsim.core.field;

import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.auvsim.core.math.Near.assertNear;

import org.auvsim.core.entity.MagneticField;
import org.auvsim.core.math.Draws;
import org.auvsim.core.math.Mat3;
import org.auvsim.core.math.Vec3;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class MagneticFieldsTest {
    private static final MagneticDipoleField WRECK =
            new MagneticDipoleField(1, "wreck", new Vec3(1, 2, -10), new Vec3(2e5, 1e5, -4e5), 2);

    /** Known by its values alone, so that its gradient is from differences. */
    private record Plain(long id, String name) implements MagneticField {
        @Override
        public Vec3 valueAt(Vec3 position, double time) {
            return WRECK.valueAt(position, time);
        }
    }

    @ParameterizedTest(name = "seed {0}")
    @ValueSource(longs = {1, 2, 3})
    void aDipoleKnowsItsGradient(long seed) {
        Draws draws = new Draws(seed);
        for (int k = 0; k < 50; k++) {
            Vec3 place = draws.vector(8);
            Mat3 gradient = WRECK.gradientAt(place, 0);
            assertNear(gradient, new Plain(2, "plain").gradientAt(place, 0), 1e-8);
            assertNear(gradient, gradient.transposed(), 1e-16);
            assertNear(
                    new Vec3(gradient.xx() + gradient.yy() + gradient.zz(), 0, 0),
                    Vec3.ZERO,
                    1e-16);
        }
    }

    /** mu0 m / (2 pi r^3) on the axis, half of it and opposite beside it (Jackson). */
    @Test
    void aDipolesFieldIsTheTextbooks() {
        MagneticDipoleField up =
                new MagneticDipoleField(1, "up", Vec3.ZERO, new Vec3(0, 0, 5), 0.1);
        assertNear(up.valueAt(new Vec3(0, 0, 2), 0), new Vec3(0, 0, 1.25e-7), 1e-20);
        assertNear(up.valueAt(new Vec3(0, -2, 0), 0), new Vec3(0, 0, -0.625e-7), 1e-20);
    }

    /** Its component through the surface does not jump there. */
    @Test
    void theNormalFieldPassesThroughTheBall() {
        for (double angle = 0.1; angle < 6; angle += 0.7) {
            Vec3 n = new Vec3(StrictMath.cos(angle), 0.6 * StrictMath.sin(angle), 0).normalized();
            Vec3 inside = WRECK.valueAt(WRECK.position().plus(n.times(2 - 1e-9)), 0);
            Vec3 outside = WRECK.valueAt(WRECK.position().plus(n.times(2 + 1e-9)), 0);
            assertNear(new Vec3(inside.dot(n), 0, 0), new Vec3(outside.dot(n), 0, 0), 1e-10);
        }
    }

    @Test
    void numbersThatMeanNothingAreRefused() {
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new MagneticDipoleField(1, "m", Vec3.ZERO, Vec3.ZERO, 0))
                .withMessageContaining("the radius of magnetic field 'm' must be above 0 m");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new UniformMagneticField(1, "m", new Vec3(Double.NaN, 0, 0)))
                .withMessageContaining("the flux density of magnetic field 'm' must be finite");
    }
}
