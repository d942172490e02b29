package org.auvsim.core.entity;

import org.auvsim.core.description.Default;
import org.auvsim.core.description.Unit;
import org.auvsim.core.math.QuadraticForm;
import org.auvsim.core.math.Vec3;

import java.util.ArrayList;
import java.util.List;

/**
 * The inertia of the water that a body carries with it (Fossen 2021, section 6.3.1): a symmetric,
 * positive semi-definite 6x6 matrix about the origin, in body axes.
 *
 * @param linear its diagonal for surge, sway and heave (kg)
 * @param angular its diagonal for roll, pitch and yaw (kg m^2)
 * @param term elements beside the diagonal; one that is stated stands for its mirror image, too,
 *     and of two that are printed a little differently (by 1e-3 at most) the mean counts
 */
public record AddedMass(
        @Unit("kg") @Default("0 0 0") Vec3 linear,
        @Unit("kg m^2") @Default("0 0 0") Vec3 angular,
        List<AddedMassTerm> term) {
    private static final double MOST_ASYMMETRY = 1e-3;

    /**
     * Checked added mass.
     *
     * @throws IllegalArgumentException if a number is not finite, an element is stated twice, the
     *     matrix is not symmetric or not positive semi-definite
     */
    public AddedMass {
        term = List.copyOf(term);
        if (!linear.isFinite() || !angular.isFinite()) {
            throw new IllegalArgumentException(
                    "added mass must be finite, but is " + linear + " and " + angular);
        }
        if (!QuadraticForm.isSemiDefinite(matrix(linear, angular, term), 6)) {
            throw new IllegalArgumentException(
                    "an added mass matrix must be positive semi-definite, as water that is moved"
                            + " never gives energy; check its signs and the elements beside the"
                            + " diagonal");
        }
    }

    /** A sentence for each two mirror images that differ and of which the mean counts. */
    public List<String> notices() {
        List<String> notices = new ArrayList<>();
        for (int i = 0; i < term.size(); i++) {
            for (AddedMassTerm mirror : term.subList(0, i)) {
                AddedMassTerm own = term.get(i);
                if (own.row() == mirror.column()
                        && own.column() == mirror.row()
                        && own.value() != mirror.value()) {
                    notices.add(difference(own, mirror.value()) + "; their mean counts");
                }
            }
        }
        return notices;
    }

    /** The 36 numbers, row by row, symmetric. */
    double[] matrix() {
        return matrix(linear, angular, term);
    }

    private static double[] matrix(Vec3 linear, Vec3 angular, List<AddedMassTerm> terms) {
        double[] matrix = new double[36];
        SpatialMatrix.setDiagonal(matrix, linear, angular);
        boolean[] stated = new boolean[36];
        for (AddedMassTerm term : terms) {
            int at = 6 * term.row().index() + term.column().index();
            int mirror = 6 * term.column().index() + term.row().index();
            if (stated[at]) {
                throw new IllegalArgumentException(
                        "the added mass of %s by %s is stated twice"
                                .formatted(term.row(), term.column()));
            }
            stated[at] = true;
            double value = stated[mirror] ? mean(term, matrix[mirror]) : term.value();
            matrix[at] = value;
            matrix[mirror] = value;
        }
        return matrix;
    }

    private static double mean(AddedMassTerm term, double mirror) {
        double largest = Math.max(Math.abs(term.value()), Math.abs(mirror));
        if (Math.abs(term.value() - mirror) > MOST_ASYMMETRY * largest) {
            throw new IllegalArgumentException(
                    difference(term, mirror) + "; they may differ by 1e-3 of the larger at most");
        }
        return term.value() / 2 + mirror / 2;
    }

    private static String difference(AddedMassTerm term, double mirror) {
        return "an added mass matrix is symmetric, but %s by %s is %s and %s by %s is %s"
                .formatted(
                        term.row(), term.column(), term.value(), term.column(), term.row(), mirror);
    }
}
