package org.auvsim.core.entity;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import org.auvsim.core.math.Vec3;
import org.junit.jupiter.api.Test;

import java.util.List;

class AddedMassTest {
    private static final Vec3 ONES = new Vec3(1, 1, 1);

    private static AddedMassTerm term(MotionAxis row, MotionAxis column, double value) {
        return new AddedMassTerm(row, column, value);
    }

    private static AddedMass with(AddedMassTerm... terms) {
        return new AddedMass(ONES, ONES, List.of(terms));
    }

    @Test
    void anElementStandsForItsMirrorImage() {
        double[] matrix = with(term(MotionAxis.SWAY, MotionAxis.YAW, 0.25)).matrix();
        assertThat(matrix[6 + 5]).isEqualTo(0.25);
        assertThat(matrix[30 + 1]).isEqualTo(0.25);
        assertThat(matrix[0]).isEqualTo(1);
        assertThat(matrix[35]).isEqualTo(1);
    }

    @Test
    void ofTwoThatAreNearlyEqualTheMeanCounts() {
        // As printed for the RexROV, a hundredth of it.
        AddedMass printed =
                with(
                        term(MotionAxis.SWAY, MotionAxis.ROLL, 0.10774),
                        term(MotionAxis.ROLL, MotionAxis.SWAY, 0.10775));
        assertThat(printed.notices())
                .containsExactly(
                        "an added mass matrix is symmetric, but ROLL by SWAY is 0.10775 and SWAY by"
                                + " ROLL is 0.10774; their mean counts");
        double[] matrix = printed.matrix();
        assertThat(matrix[6 + 3]).isEqualTo(matrix[18 + 1]).isBetween(0.10774, 0.10775);
    }

    @Test
    void ofTwoThatAreEqualNothingIsSaid() {
        assertThat(
                        with(
                                        term(MotionAxis.SWAY, MotionAxis.ROLL, 0.1),
                                        term(MotionAxis.HEAVE, MotionAxis.PITCH, 0.2),
                                        term(MotionAxis.ROLL, MotionAxis.SWAY, 0.1))
                                .notices())
                .isEmpty();
    }

    @Test
    void asymmetryIsRefused() {
        assertThatIllegalArgumentException()
                .isThrownBy(
                        () ->
                                with(
                                        term(MotionAxis.SWAY, MotionAxis.YAW, 0.25),
                                        term(MotionAxis.YAW, MotionAxis.SWAY, -0.25)))
                .withMessage(
                        "an added mass matrix is symmetric, but YAW by SWAY is -0.25 and SWAY by"
                                + " YAW is 0.25; they may differ by 1e-3 of the larger at most");
    }

    @Test
    void whatWouldGiveEnergyIsRefused() {
        assertThatIllegalArgumentException()
                .isThrownBy(() -> with(term(MotionAxis.SWAY, MotionAxis.YAW, 1.1)))
                .withMessageContaining("positive semi-definite");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new AddedMass(new Vec3(-1, 0, 0), ONES, List.of()))
                .withMessageContaining("positive semi-definite");
        assertThatIllegalArgumentException()
                .isThrownBy(
                        () ->
                                new AddedMass(
                                        new Vec3(1, 0, 1),
                                        ONES,
                                        List.of(term(MotionAxis.SWAY, MotionAxis.YAW, 0.1))))
                .withMessageContaining("positive semi-definite");
    }

    @Test
    void zerosAreAllowed() {
        assertThat(new AddedMass(Vec3.ZERO, Vec3.ZERO, List.of()).matrix()).containsOnly(0);
        assertThat(with(term(MotionAxis.SWAY, MotionAxis.YAW, 1)).matrix()[11]).isEqualTo(1);
    }

    @Test
    void anElementIsStatedOnceAndNotOnTheDiagonal() {
        AddedMassTerm term = term(MotionAxis.SURGE, MotionAxis.PITCH, 0.1);
        assertThatIllegalArgumentException()
                .isThrownBy(() -> with(term, term))
                .withMessage("the added mass of SURGE by PITCH is stated twice");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> term(MotionAxis.SURGE, MotionAxis.SURGE, 1));
    }
}
