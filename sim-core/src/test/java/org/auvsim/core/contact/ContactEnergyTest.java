package org.auvsim.core.contact;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

import java.util.stream.LongStream;

/** What holds for any impact, whatever the bodies, the contacts, friction and restitution. */
class ContactEnergyTest {
    private static final int CASES = 500;

    private final ContactSolver solver = ContactSolver.forImpacts();
    private int converged;
    private int lowered;

    static LongStream seeds() {
        return LongStream.rangeClosed(1, 4);
    }

    private static Drawn drawn(long seed, int i, double friction, double restitution) {
        Drawn drawn = new Drawn(CASES * seed + i).bodies(2 + i % 4);
        if (i % 3 == 0) {
            drawn.fixed();
        }
        return drawn.contacts(1 + i % 9, friction, restitution);
    }

    @ParameterizedTest(name = "seed {0}")
    @MethodSource("seeds")
    void noContactAddsEnergy(long seed) {
        for (int i = 0; i < CASES; i++) {
            Drawn drawn = drawn(seed, i, i % 2 == 0 ? 0 : 1.5, i % 5 == 0 ? 0 : 1);
            double before = drawn.energy(drawn.bodies.v);
            Solution solution = solver.solve(drawn.bodies, drawn.contacts);
            double after = drawn.energy(drawn.bodies.v);
            assertThat(after).as("case %d", i).isLessThanOrEqualTo(before * (1 + 1e-12));
            assertThat(after - before).isCloseTo(solution.energyGain(), within(1e-11 * before));
            assertParted(drawn, solution, i);
            converged += solution.converged() ? 1 : 0;
            lowered += solution.bounceKept() < 1 ? 1 : 0;
        }
        assertThat(converged).isGreaterThan(CASES * 85 / 100);
        assertThat(lowered).isGreaterThan(0);
    }

    private static void assertParted(Drawn drawn, Solution solution, int i) {
        Contacts contacts = drawn.contacts;
        for (int c = 0; c < contacts.count; c++) {
            assertThat(contacts.jn[c]).isNotNegative();
            double across =
                    Math.sqrt(
                            contacts.jx[c] * contacts.jx[c]
                                    + contacts.jy[c] * contacts.jy[c]
                                    + contacts.jz[c] * contacts.jz[c]);
            assertThat(across)
                    .isLessThanOrEqualTo(
                            contacts.friction[c] * contacts.jn[c] * (1 + 1e-9) + 1e-13);
            if (solution.converged()) {
                double wanted = solution.bounceKept() * contacts.target[c];
                assertThat(contacts.separationSpeed(c, drawn.bodies))
                        .as("case %d contact %d", i, c)
                        .isGreaterThan(wanted - 1e-7);
            }
        }
    }

    @ParameterizedTest(name = "seed {0}")
    @MethodSource("seeds")
    void momentaOfFreeBodiesAreKept(long seed) {
        for (int i = 0; i < CASES; i++) {
            Drawn drawn = new Drawn(CASES * seed + i).bodies(3).contacts(4, 1, 1);
            double[] before = total(drawn);
            solver.solve(drawn.bodies, drawn.contacts);
            assertThat(total(drawn)).containsExactly(before, within(1e-10));
        }
    }

    /** Momentum and angular momentum about the world's origin. */
    private static double[] total(Drawn drawn) {
        double[] total = new double[6];
        for (int body = 0; body < drawn.bodies.count; body++) {
            double[] p = drawn.momentum(body, drawn.bodies.v);
            double[] x = drawn.bodies.x;
            int at = 3 * body;
            total[0] += p[0];
            total[1] += p[1];
            total[2] += p[2];
            total[3] += p[3] + x[at + 1] * p[2] - x[at + 2] * p[1];
            total[4] += p[4] + x[at + 2] * p[0] - x[at] * p[2];
            total[5] += p[5] + x[at] * p[1] - x[at + 1] * p[0];
        }
        return total;
    }
}
