package org.auvsim.core.contact;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class ContactSolverTest {
    private final ContactBodies bodies = new ContactBodies();
    private final Contacts contacts = new Contacts();
    private final ContactSolver solver = ContactSolver.forImpacts();

    private int ball(double x, double mass, double speed) {
        int body = bodies.add(x, 0, 0);
        for (int i = 0; i < 3; i++) {
            bodies.k[36 * body + 7 * i] = 1 / mass;
            bodies.k[36 * body + 7 * (i + 3)] = 1 / (0.4 * mass * 0.25);
        }
        bodies.v[6 * body] = speed;
        return body;
    }

    /** A row of balls that touch along x; the first is the fast one. */
    private void cradle(int count, double... speeds) {
        for (int i = 0; i < count; i++) {
            ball(i, 1, i < speeds.length ? speeds[i] : 0);
        }
        for (int i = 0; i + 1 < count; i++) {
            int c = contacts.add(i, i + 1, i + 0.5, 0, 0, -1, 0, 0);
            contacts.target[c] = Math.max(0, -contacts.separationSpeed(c, bodies));
        }
    }

    private double speed(int body) {
        return bodies.v[6 * body];
    }

    @Test
    void nothingToSolveIsSolved() {
        ball(0, 1, 3);
        Solution solution = solver.solve(bodies, contacts);
        assertThat(solution.converged()).isTrue();
        assertThat(solution.energyGain()).isEqualTo(0);
        assertThat(speed(0)).isEqualTo(3);
    }

    @ParameterizedTest(name = "seed {0}, restitution {1}")
    @CsvSource({"1, 0", "2, 0.3", "3, 0.9", "4, 1", "5, 1", "6, 0.5", "7, 1", "8, 0"})
    void oneContactGetsWhatTheFormulaSays(long seed, double restitution) {
        Drawn drawn = new Drawn(seed).bodies(2).contacts(1, 0, 0);
        double before = drawn.contacts.separationSpeed(0, drawn.bodies);
        if (before > 0) {
            drawn.contacts.nx[0] *= -1;
            drawn.contacts.ny[0] *= -1;
            drawn.contacts.nz[0] *= -1;
            before = -before;
        }
        drawn.bounce(0, restitution);
        double expected =
                -(1 + restitution)
                        * before
                        / (form(drawn, drawn.contacts.a[0]) + form(drawn, drawn.contacts.b[0]));
        double energy = drawn.energy(drawn.bodies.v);
        Solution solution = solver.solve(drawn.bodies, drawn.contacts);
        assertThat(solution.converged()).isTrue();
        assertThat(drawn.contacts.jn[0]).isCloseTo(expected, within(1e-12 * expected));
        assertThat(drawn.contacts.separationSpeed(0, drawn.bodies))
                .isCloseTo(-restitution * before, within(-1e-12 * before));
        double lost = 0.5 * (1 + restitution) * (1 - restitution) * before * expected;
        assertThat(drawn.energy(drawn.bodies.v))
                .isCloseTo(energy + lost / (1 + restitution), within(1e-12 * energy));
        assertThat(solution.bounceKept()).isEqualTo(1);
    }

    /** w . K w of physics.md, w = (n, r x n). */
    private static double form(Drawn drawn, int body) {
        double[] k = drawn.bodies.k;
        double[] x = drawn.bodies.x;
        double[] n = {drawn.contacts.nx[0], drawn.contacts.ny[0], drawn.contacts.nz[0]};
        double[] r = {
            drawn.contacts.px[0] - x[3 * body],
            drawn.contacts.py[0] - x[3 * body + 1],
            drawn.contacts.pz[0] - x[3 * body + 2]
        };
        double[] w = {
            n[0],
            n[1],
            n[2],
            r[1] * n[2] - r[2] * n[1],
            r[2] * n[0] - r[0] * n[2],
            r[0] * n[1] - r[1] * n[0]
        };
        double sum = 0;
        for (int i = 0; i < 6; i++) {
            for (int m = 0; m < 6; m++) {
                sum += w[i] * k[36 * body + 6 * i + m] * w[m];
            }
        }
        return sum;
    }

    @Test
    void bodiesThatPartGetNothing() {
        cradle(2, -1, 1);
        Solution solution = solver.solve(bodies, contacts);
        assertThat(contacts.jn[0]).isEqualTo(0);
        assertThat(solution.energyGain()).isEqualTo(0);
        assertThat(speed(0)).isEqualTo(-1);
    }

    @Test
    void bodiesThatCannotMoveGetNothing() {
        bodies.add(0, 0, 0);
        bodies.add(1, 0, 0);
        bodies.v[0] = 1;
        contacts.add(0, 1, 0.5, 0, 0, -1, 0, 0);
        contacts.guess(0, 7, 1, 2, 3);
        contacts.friction[0] = 1;
        Solution solution = solver.solve(bodies, contacts);
        assertThat(solution.converged()).isTrue();
        assertThat(contacts.jn[0]).isEqualTo(0);
        assertThat(contacts.jy[0]).isEqualTo(0);
        assertThat(bodies.v[0]).isEqualTo(1);
    }

    /**
     * Solved by hand: v_i' - v_(i+1)' = 0 but at the first contact, where they part with the speed
     * of the approach; so the rest moves as one and the first ball bounces off it.
     */
    @ParameterizedTest(name = "{0} balls")
    @ValueSource(ints = {2, 3, 5, 8, 12})
    void aBallOnARowOfTouchingBallsBouncesOffTheRow(int count) {
        cradle(count, 1);
        Solution solution = solver.solve(bodies, contacts);
        assertThat(solution.converged()).isTrue();
        double row = 2.0 / count;
        assertThat(speed(0)).isCloseTo(row - 1, within(1e-9));
        for (int i = 1; i < count; i++) {
            assertThat(speed(i)).isCloseTo(row, within(1e-9));
        }
        assertThat(solution.energyGain()).isBetween(-1e-9, 0.0);
    }

    @Test
    void ballsFromBothEndsBounceBackAlike() {
        cradle(5, 1, 0, 0, 0, -1);
        solver.solve(bodies, contacts);
        assertThat(speed(0)).isCloseTo(-1, within(1e-9));
        assertThat(speed(4)).isCloseTo(1, within(1e-9));
        assertThat(speed(2)).isCloseTo(0, within(1e-9));
    }

    @Test
    void theSameInputGivesTheSameBits() {
        Drawn one = new Drawn(7).bodies(4).contacts(12, 1, 1);
        Drawn other = new Drawn(7).bodies(4).contacts(12, 1, 1);
        solver.solve(one.bodies, one.contacts);
        ContactSolver.forImpacts().solve(other.bodies, other.contacts);
        assertThat(one.bodies.v).containsExactly(other.bodies.v);
        assertThat(one.contacts.jn).containsExactly(other.contacts.jn);
    }

    @Test
    void aSolverOfTooFewSweepsIsRefused() {
        assertThatThrownBy(() -> ContactSolver.forResting(1e-6, 1))
                .hasMessageContaining("at least 2 sweeps, not 1.0E-6 and 1.");
        assertThatThrownBy(() -> ContactSolver.forResting(Double.NaN, 9))
                .isInstanceOf(IllegalArgumentException.class);
    }
}
