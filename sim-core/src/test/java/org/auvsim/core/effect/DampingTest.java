package org.auvsim.core.effect;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import org.auvsim.core.entity.Block;
import org.auvsim.core.entity.BodyEffect;
import org.auvsim.core.entity.MotionAxis;
import org.auvsim.core.field.UniformCurrent;
import org.auvsim.core.math.Draws;
import org.auvsim.core.math.Vec3;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

import java.util.ArrayList;
import java.util.List;

/** Damping with elements beside the diagonal. */
class DampingTest {
    private static final Vec3 ONES = new Vec3(1, 1, 1);
    private static final Damping FULL =
            new Damping(
                    new Vec3(3, 4, 5),
                    new Vec3(6, 70, 8),
                    new Vec3(5, 6, 7),
                    new Vec3(8, 9, 10),
                    List.of(
                            new DampingTerm(MotionAxis.SWAY, MotionAxis.YAW, 2, -3),
                            new DampingTerm(MotionAxis.YAW, MotionAxis.SWAY, -1, 4),
                            new DampingTerm(MotionAxis.HEAVE, MotionAxis.PITCH, 1.5, 0)));

    /** As the comment of Damping says it: a sum over rows and columns. */
    private record Sum(Damping d) implements BodyEffect {
        @Override
        public void add(Block block, int i) {
            Vec3 v = block.toBody(i, block.velocity(i).minus(block.waterVelocity(i)));
            double[] tau = forces(d, v, block.bodyAngularVelocity(i));
            block.addForce(i, block.toWorld(i, new Vec3(tau[0], tau[1], tau[2])));
            block.addTorque(i, block.toWorld(i, new Vec3(tau[3], tau[4], tau[5])));
        }
    }

    private static double[] forces(Damping d, Vec3 v, Vec3 w) {
        double[] nu = six(v, w);
        double[] a = six(d.linear(), d.angularLinear());
        double[] b = six(d.quadratic(), d.angularQuadratic());
        double[] tau = new double[6];
        for (int k = 0; k < 6; k++) {
            tau[k] -= (a[k] + b[k] * Math.abs(nu[k])) * nu[k];
        }
        for (DampingTerm t : d.term()) {
            double along = nu[t.column().index()];
            tau[t.row().index()] -= (t.linear() + t.quadratic() * Math.abs(along)) * along;
        }
        return tau;
    }

    private static double[] six(Vec3 a, Vec3 b) {
        return new double[] {a.x(), a.y(), a.z(), b.x(), b.y(), b.z()};
    }

    @ParameterizedTest(name = "seed {0}")
    @ValueSource(longs = {1, 2, 3})
    void elementsBesideTheDiagonalCoupleTheAxes(long seed) {
        BodyByBody.assertSameMotion(
                seed,
                FULL,
                new Sum(FULL),
                new UniformCurrent(999, "stream", new Vec3(0.5, -0.3, 0.2)));
    }

    /** Whatever matrices pass the check, no motion is ever fed energy. */
    @ParameterizedTest(name = "seed {0}")
    @ValueSource(longs = {1, 2, 3, 4, 5})
    void whatIsAcceptedTakesEnergyFromEveryMotion(long seed) {
        Draws draws = new Draws(seed);
        int accepted = 0;
        int refused = 0;
        while (accepted < 50) {
            try {
                Damping damping = drawn(draws);
                for (int k = 0; k < 200; k++) {
                    Vec3 v = draws.vector(3);
                    Vec3 w = draws.vector(3);
                    double[] tau = forces(damping, v, w);
                    double power = 0;
                    for (int axis = 0; axis < 6; axis++) {
                        power += tau[axis] * six(v, w)[axis];
                    }
                    assertThat(power).isLessThanOrEqualTo(1e-9);
                }
                accepted++;
            } catch (IllegalArgumentException e) {
                refused++;
            }
        }
        assertThat(refused).isPositive();
    }

    private static Damping drawn(Draws draws) {
        List<DampingTerm> terms = new ArrayList<>();
        MotionAxis[] axes = MotionAxis.values();
        for (int k = 0; k < 4; k++) {
            MotionAxis row = axes[(int) draws.number(0, 6)];
            MotionAxis column = axes[(int) draws.number(0, 6)];
            if (row != column) {
                terms.add(new DampingTerm(row, column, draws.number(-3, 3), draws.number(-3, 3)));
            }
        }
        return new Damping(
                draws.vector(0, 5),
                draws.vector(0, 5),
                draws.vector(0, 5),
                draws.vector(0, 5),
                terms);
    }

    /** Against the lowest of many motions: for one pair of axes the check is exact. */
    @ParameterizedTest(name = "seed {0}")
    @ValueSource(longs = {1, 2, 3})
    void thePowerOfACoupledPairIsTestedExactly(long seed) {
        Draws draws = new Draws(seed);
        int positive = 0;
        for (int k = 0; k < 500; k++) {
            double a = draws.number(0, 2);
            double b = draws.number(0, 2);
            double c = draws.number(-2, 2);
            double d = draws.number(-2, 2);
            double lowest = lowest(a, c, d, b);
            if (Math.abs(lowest) > 1e-4) {
                assertThat(CubicForm.isNeverNegative(a, c, d, b)).isEqualTo(lowest > 0);
                positive += lowest > 0 ? 1 : 0;
            }
        }
        assertThat(positive).isBetween(50, 450);
    }

    private static double lowest(double a, double c, double d, double b) {
        double lowest = Double.POSITIVE_INFINITY;
        for (int k = 0; k < 2000; k++) {
            double x = StrictMath.cos(k * Math.PI / 1000);
            double y = StrictMath.sin(k * Math.PI / 1000);
            double power =
                    x * (a * Math.abs(x) * x + d * Math.abs(y) * y)
                            + y * (c * Math.abs(x) * x + b * Math.abs(y) * y);
            lowest = Math.min(lowest, power);
        }
        return lowest;
    }

    @Test
    void linearTermsThatExceedTheDiagonalAreRefused() {
        assertThatIllegalArgumentException()
                .isThrownBy(() -> damping(new DampingTerm(MotionAxis.SWAY, MotionAxis.YAW, 2.1, 0)))
                .withMessageContaining("linear damping")
                .withMessageContaining("SWAY by YAW is 2.1 and YAW by SWAY is 0.0");
        assertThat(damping(new DampingTerm(MotionAxis.SWAY, MotionAxis.YAW, 1.9, 0)).term())
                .hasSize(1);
    }

    /** x^3 + k x y^2 + y^3 has its lowest value 0 at k = -3/4^(1/3). */
    @ParameterizedTest
    @CsvSource({"1.8898, true", "1.8899, false", "-1.8898, true", "-1.8899, false"})
    void quadraticTermsMayBeAsLargeAsTheirFormAllows(double k, boolean fine) {
        DampingTerm term = new DampingTerm(MotionAxis.SURGE, MotionAxis.PITCH, 0, k);
        if (fine) {
            assertThat(damping(term).term()).containsExactly(term);
        } else {
            assertThatIllegalArgumentException()
                    .isThrownBy(() -> damping(term))
                    .withMessageContaining("quadratic damping")
                    .withMessageContaining("SURGE by PITCH is " + k);
        }
    }

    private static Damping damping(DampingTerm term) {
        return new Damping(ONES, ONES, ONES, ONES, List.of(term));
    }

    @Test
    void aTermIsBesideTheDiagonalFiniteAndStatedOnce() {
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new DampingTerm(MotionAxis.YAW, MotionAxis.YAW, 1, 0))
                .withMessageContaining("the damping of YAW by itself");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new DampingTerm(MotionAxis.YAW, MotionAxis.SWAY, Double.NaN, 0))
                .withMessage(
                        "the linear coefficient of damping of YAW by SWAY must be finite, but is"
                                + " NaN");
        DampingTerm term = new DampingTerm(MotionAxis.SWAY, MotionAxis.YAW, 0.1, 0);
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new Damping(ONES, ONES, ONES, ONES, List.of(term, term)))
                .withMessage("the damping of SWAY by YAW is stated twice");
    }
}
