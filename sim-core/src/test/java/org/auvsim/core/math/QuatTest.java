package org.auvsim.core.math;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;
import static org.auvsim.core.math.Near.assertNear;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class QuatTest {
    private static final Vec3 X = new Vec3(1, 0, 0);
    private static final Vec3 Y = new Vec3(0, 1, 0);
    private static final Vec3 Z = new Vec3(0, 0, 1);

    @Test
    void aQuarterTurnAboutZTakesXToY() {
        Quat quarter = Quat.ofAxisAngle(new Vec3(0, 0, 7), Math.PI / 2);
        assertNear(quarter.rotate(X), Y, 1e-15);
        assertNear(quarter.rotate(Y), X.negated(), 1e-15);
        assertNear(quarter.rotate(Z), Z, 1e-15);
    }

    @Test
    void theUnitsMultiplyAsHamiltonCarvedThem() {
        Quat i = new Quat(0, 1, 0, 0);
        Quat j = new Quat(0, 0, 1, 0);
        Quat k = new Quat(0, 0, 0, 1);
        assertThat(i.times(j)).isEqualTo(k);
        assertThat(j.times(k)).isEqualTo(i);
        assertThat(k.times(i)).isEqualTo(j);
        assertThat(i.times(j).times(k)).isEqualTo(new Quat(-1, 0, 0, 0));
    }

    @ParameterizedTest(name = "seed {0}")
    @ValueSource(longs = {1, 2, 3, 4})
    void theProductTurnsByTheRightOneFirst(long seed) {
        Draws draws = new Draws(seed);
        Quat p = draws.orientation();
        Quat q = draws.orientation();
        Vec3 v = draws.vector(5);
        assertNear(p.times(q).rotate(v), p.rotate(q.rotate(v)), 1e-14);
        assertNear(p.times(q).toMatrix(), p.toMatrix().times(q.toMatrix()), 1e-14);
    }

    @ParameterizedTest(name = "seed {0}")
    @ValueSource(longs = {1, 2, 3, 4})
    void turningKeepsLengthsAndAnglesAndIsUndone(long seed) {
        Draws draws = new Draws(seed);
        Quat q = draws.orientation();
        Vec3 u = draws.vector(5);
        Vec3 v = draws.vector(5);
        assertThat(q.rotate(u).dot(q.rotate(v))).isCloseTo(u.dot(v), within(1e-13));
        assertNear(q.rotate(u.cross(v)), q.rotate(u).cross(q.rotate(v)), 1e-13);
        assertNear(q.rotateInverse(q.rotate(v)), v, 1e-14);
        assertNear(q.conjugate().rotate(v), q.rotateInverse(v), 1e-14);
        assertThat(q.toMatrix().determinant()).isCloseTo(1, within(1e-14));
    }

    @ParameterizedTest(name = "seed {0}")
    @ValueSource(longs = {1, 2, 3, 4})
    void aTurnAboutAnAxisIsRodriguesFormula(long seed) {
        Draws draws = new Draws(seed);
        Vec3 n = draws.direction();
        double angle = draws.number(-6, 6);
        Vec3 v = draws.vector(5);
        Vec3 expected =
                v.times(Math.cos(angle))
                        .plus(n.cross(v).times(Math.sin(angle)))
                        .plus(n.times(n.dot(v) * (1 - Math.cos(angle))));
        assertNear(Quat.ofAxisAngle(n.times(3), angle).rotate(v), expected, 1e-13);
    }

    @ParameterizedTest(name = "seed {0}")
    @ValueSource(longs = {1, 2, 3})
    void itIsFoundInTheMatrixThatItMakes(long seed) {
        Draws draws = new Draws(seed);
        for (int i = 0; i < 200; i++) {
            assertFoundInItsMatrix(draws.orientation());
        }
    }

    /** Half turns, where one of the four squares alone is not small. */
    @ParameterizedTest
    @CsvSource({"1, 0, 0, 0", "0, 1, 0, 0", "0, 0, 1, 0", "0, 0, 0, 1", "1e-9, 0.6, 0, -0.8"})
    void halfTurnsAreFoundInTheirMatrices(double w, double x, double y, double z) {
        assertFoundInItsMatrix(new Quat(w, x, y, z).normalized());
    }

    private static void assertFoundInItsMatrix(Quat expected) {
        Quat found = Quat.of(expected.toMatrix());
        Quat difference = found.times(expected.conjugate());
        assertThat(found.w()).isNotNegative();
        assertThat(Math.abs(difference.w())).isCloseTo(1, within(1e-14));
    }

    @Test
    void normalizingKeepsTheDirection() {
        assertThat(new Quat(0, 3, 0, 4).normalized()).isEqualTo(new Quat(0, 0.6, 0, 0.8));
    }

    @Test
    void whatHasNoDirectionIsRefused() {
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new Quat(0, 0, 0, 0).normalized())
                .withMessageStartingWith("an orientation needs a finite length above 0, but");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new Quat(1, Double.NaN, 0, 0).normalized());
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new Quat(Double.POSITIVE_INFINITY, 0, 0, 0).normalized());
        assertThatIllegalArgumentException().isThrownBy(() -> Quat.ofAxisAngle(Vec3.ZERO, 1));
    }

    @Test
    void finiteMeansAllFour() {
        assertThat(Quat.IDENTITY.isFinite()).isTrue();
        assertThat(new Quat(1, 0, 0, Double.NaN).isFinite()).isFalse();
        assertThat(new Quat(Double.NEGATIVE_INFINITY, 0, 0, 0).isFinite()).isFalse();
    }

    @Test
    void itsTextIsThatOfAVectorWithTheRealPartFirst() {
        assertThat(new Quat(1, 0.5, 0, -2)).hasToString("(1.0, 0.5, 0.0, -2.0)");
    }
}
