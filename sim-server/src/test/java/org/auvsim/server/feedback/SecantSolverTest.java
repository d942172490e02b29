package org.auvsim.server.feedback;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

import java.util.Optional;

class SecantSolverTest {
    @Test
    void solvesCoupledNonlinearEquations() {
        double[] x =
                SecantSolver.solve(
                                at ->
                                        Optional.of(
                                                new double[] {
                                                    at[0] + 0.3 * at[1] * at[1] - 1,
                                                    at[1] + 0.2 * Math.sin(at[0]) - 0.5
                                                }),
                                2)
                        .found();
        assertThat(Math.abs(x[0] + 0.3 * x[1] * x[1] - 1)).isLessThan(2e-9);
        assertThat(Math.abs(x[1] + 0.2 * Math.sin(x[0]) - 0.5)).isLessThan(2e-9);
    }

    @Test
    void staysWhereNothingBringsItNearer() {
        SecantSolver solution = SecantSolver.solve(_ -> Optional.of(new double[] {1}), 1);
        assertThat(solution.found()).containsExactly(0);
        assertThat(solution.missed()).isEqualTo(1);
        assertThat(solution.isExact()).isFalse();
    }

    /** The unknowns act on each other's equations alone: the identity leads nowhere. */
    @Test
    void measuresWhatTheUnknownsDoWhereItsGuessLeadsNowhere() {
        SecantSolver solution =
                SecantSolver.solve(
                        at -> Optional.of(new double[] {1e3 * at[1] - 1, -1e3 * at[0] - 2}), 2);
        assertThat(solution.isExact()).isTrue();
        assertThat(Math.abs(solution.found()[1] - 1e-3)).isLessThan(1e-11);
    }

    @Test
    void goesAroundWhatCannotBeTried() {
        double[] x =
                SecantSolver.solve(
                                at ->
                                        at[0] > 0.6
                                                ? Optional.empty()
                                                : Optional.of(new double[] {2 * at[0] - 1}),
                                1)
                        .found();
        assertThat(Math.abs(2 * x[0] - 1)).isLessThan(2e-9);
    }

    @Test
    void givesZeroIfNothingCanBeTried() {
        assertThat(SecantSolver.solve(_ -> Optional.empty(), 3).found()).containsExactly(0, 0, 0);
    }
}
