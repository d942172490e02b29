package org.auvsim.core.math;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static org.auvsim.core.math.Near.assertNear;

import org.apache.commons.math3.linear.Array2DRowRealMatrix;
import org.apache.commons.math3.linear.LUDecomposition;
import org.apache.commons.math3.linear.RealMatrix;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class Mat3Test {
    @ParameterizedTest(name = "seed {0}")
    @ValueSource(longs = {1, 2, 3, 4})
    void productsAndDeterminantAreThoseOfLinearAlgebra(long seed) {
        Draws draws = new Draws(seed);
        Mat3 a = draws.matrix(3);
        Mat3 b = draws.matrix(3);
        Vec3 v = draws.vector(3);
        assertNear(a.times(b), of(general(a).multiply(general(b))), 1e-13);
        double[] product = general(a).operate(new double[] {v.x(), v.y(), v.z()});
        assertNear(a.times(v), new Vec3(product[0], product[1], product[2]), 1e-13);
        assertThat(a.determinant())
                .isCloseTo(new LUDecomposition(general(a)).getDeterminant(), within(1e-12));
        assertThat(a.transposed()).isEqualTo(of(general(a).transpose()));
    }

    @ParameterizedTest(name = "seed {0}")
    @ValueSource(longs = {1, 2, 3, 4})
    void theInverseUndoes(long seed) {
        Mat3 a = new Draws(seed).matrix(3);
        Mat3 inverse = a.inverse().orElseThrow();
        assertNear(a.times(inverse), Mat3.IDENTITY, 1e-12);
        assertNear(inverse.times(a), Mat3.IDENTITY, 1e-12);
    }

    @Test
    void aSingularMatrixHasNoInverse() {
        assertThat(Mat3.diagonal(1, 0, 1).inverse()).isEmpty();
        assertThat(Mat3.diagonal(1, Double.NaN, 1).inverse()).isEmpty();
        assertThat(Mat3.diagonal(1e200, 1e200, 1).inverse()).isEmpty();
    }

    @Test
    void symmetryIsExact() {
        assertThat(new Mat3(1, 2, 3, 2, 4, 5, 3, 5, 6).isSymmetric()).isTrue();
        assertThat(new Mat3(1, 2, 3, 2, 4, 5, 3, Math.nextUp(5.0), 6).isSymmetric()).isFalse();
    }

    private static RealMatrix general(Mat3 m) {
        return new Array2DRowRealMatrix(
                new double[][] {
                    {m.xx(), m.xy(), m.xz()}, {m.yx(), m.yy(), m.yz()}, {m.zx(), m.zy(), m.zz()}
                });
    }

    private static Mat3 of(RealMatrix m) {
        return new Mat3(
                m.getEntry(0, 0),
                m.getEntry(0, 1),
                m.getEntry(0, 2),
                m.getEntry(1, 0),
                m.getEntry(1, 1),
                m.getEntry(1, 2),
                m.getEntry(2, 0),
                m.getEntry(2, 1),
                m.getEntry(2, 2));
    }
}
