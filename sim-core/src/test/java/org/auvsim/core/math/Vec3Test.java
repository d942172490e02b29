package org.auvsim.core.math;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;
import static org.auvsim.core.math.Near.assertNear;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class Vec3Test {
    @Test
    void sumsDifferencesAndMultiplesGoByComponent() {
        Vec3 a = new Vec3(1, 2, 3);
        Vec3 b = new Vec3(10, 20, 40);
        assertThat(a.plus(b)).isEqualTo(new Vec3(11, 22, 43));
        assertThat(b.minus(a)).isEqualTo(new Vec3(9, 18, 37));
        assertThat(a.times(-2)).isEqualTo(new Vec3(-2, -4, -6));
        assertThat(a.negated()).isEqualTo(new Vec3(-1, -2, -3));
        assertThat(a.dot(b)).isEqualTo(170);
        assertThat(new Vec3(2, 3, 6).norm()).isEqualTo(7);
        assertThat(a.distance(new Vec3(1, 5, 7))).isEqualTo(5);
        assertThat(a).hasToString("(1.0, 2.0, 3.0)");
    }

    @Test
    void theVectorProductIsRightHanded() {
        assertThat(new Vec3(1, 0, 0).cross(new Vec3(0, 1, 0))).isEqualTo(new Vec3(0, 0, 1));
    }

    @ParameterizedTest(name = "seed {0}")
    @ValueSource(longs = {1, 2, 3, 4})
    void theVectorProductIsNormalToBothAndAsLongAsTheirArea(long seed) {
        Draws draws = new Draws(seed);
        Vec3 a = draws.vector(4);
        Vec3 b = draws.vector(4);
        Vec3 c = a.cross(b);
        assertThat(c.dot(a)).isCloseTo(0, within(1e-13));
        assertThat(c.dot(b)).isCloseTo(0, within(1e-13));
        double square = a.dot(a) * b.dot(b) - a.dot(b) * a.dot(b);
        assertThat(c.dot(c)).isCloseTo(square, within(1e-11));
        assertNear(b.cross(a), c.negated(), 0);
    }

    @Test
    void normalizingKeepsTheDirection() {
        assertNear(new Vec3(0, 3, 4).normalized(), new Vec3(0, 0.6, 0.8), 1e-15);
        assertThatIllegalArgumentException()
                .isThrownBy(Vec3.ZERO::normalized)
                .withMessage(
                        "a direction needs a finite length above 0, but (0.0, 0.0, 0.0) has 0.0");
    }

    @Test
    void componentsAreCountedFromX() {
        Vec3 v = new Vec3(1, 2, 3);
        assertThat(v.component(0)).isEqualTo(1);
        assertThat(v.component(1)).isEqualTo(2);
        assertThat(v.component(2)).isEqualTo(3);
        assertThatIllegalArgumentException()
                .isThrownBy(() -> v.component(3))
                .withMessage("an axis is 0, 1 or 2, but not 3");
    }

    @Test
    void finiteMeansAllThree() {
        assertThat(Vec3.ZERO.isFinite()).isTrue();
        assertThat(new Vec3(0, 0, Double.NaN).isFinite()).isFalse();
        assertThat(new Vec3(Double.POSITIVE_INFINITY, 0, 0).isFinite()).isFalse();
    }
}
