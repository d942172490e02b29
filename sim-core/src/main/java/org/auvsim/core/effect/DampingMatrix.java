package org.auvsim.core.effect;

import org.auvsim.core.entity.MotionAxis;
import org.auvsim.core.math.QuadraticForm;
import org.auvsim.core.math.Vec3;

/** One of the two 6x6 matrices of a damping while it is checked. */
final class DampingMatrix {
    private static final MotionAxis[] AXES = MotionAxis.values();
    private static final int SIZE = AXES.length;

    private final String kind;
    private final double[] elements = new double[SIZE * SIZE];
    private final boolean[] stated = new boolean[SIZE * SIZE];

    /**
     * With this diagonal.
     *
     * @param kind what sentences call it: "linear"
     */
    DampingMatrix(String kind, Vec3 linear, Vec3 angular) {
        this.kind = kind;
        double[] diagonal = {
            linear.x(), linear.y(), linear.z(), angular.x(), angular.y(), angular.z()
        };
        for (int i = 0; i < SIZE; i++) {
            elements[(SIZE + 1) * i] = diagonal[i];
        }
    }

    void put(MotionAxis row, MotionAxis column, double value) {
        int at = SIZE * row.index() + column.index();
        if (stated[at]) {
            throw new IllegalArgumentException(
                    "the damping of %s by %s is stated twice".formatted(row, column));
        }
        stated[at] = true;
        elements[at] = value;
    }

    /** Refuses it unless nu^T A nu is 0 or more for all nu. */
    void requireDissipativeLinear() {
        if (QuadraticForm.isSemiDefinite(elements, SIZE)) {
            return;
        }
        for (int i = 0; i < SIZE; i++) {
            for (int j = i + 1; j < SIZE; j++) {
                double mean = at(i, j) / 2 + at(j, i) / 2;
                if (mean * mean > at(i, i) * at(j, j)) {
                    throw refused(i, j, at(i, i), at(j, j));
                }
            }
        }
        throw new IllegalArgumentException(
                "the linear damping matrix must be positive semi-definite, as water gives no"
                        + " energy, but its terms together exceed its diagonal");
    }

    /**
     * Refuses it unless the power taken, the sum of nu_i b_ij |nu_j| nu_j, is 0 or more for all nu.
     * Each pair of coupled axes is given an equal share of its axes' diagonal elements and tested
     * exactly: the sum is then 0 or more, too. Where each axis is coupled to one other, this is
     * exact; otherwise it may ask for more than is needed.
     */
    void requireDissipativeQuadratic() {
        for (int i = 0; i < SIZE; i++) {
            for (int j = i + 1; j < SIZE; j++) {
                if (isCoupled(i, j)) {
                    double own = at(i, i) / couplings(i);
                    double other = at(j, j) / couplings(j);
                    if (!CubicForm.isNeverNegative(own, at(j, i), at(i, j), other)) {
                        throw refused(i, j, own, other);
                    }
                }
            }
        }
    }

    private int couplings(int axis) {
        int count = 0;
        for (int other = 0; other < SIZE; other++) {
            count += other != axis && isCoupled(axis, other) ? 1 : 0;
        }
        return count;
    }

    private boolean isCoupled(int i, int j) {
        return at(i, j) != 0 || at(j, i) != 0;
    }

    private double at(int row, int column) {
        return elements[SIZE * row + column];
    }

    private IllegalArgumentException refused(int i, int j, double own, double other) {
        return new IllegalArgumentException(
                ("the %s damping must take energy from every motion, but %s by %s is %s and %s by"
                     + " %s is %s: too much for the %s and %s on the diagonal that they have to"
                     + " themselves")
                        .formatted(
                                kind, AXES[i], AXES[j], at(i, j), AXES[j], AXES[i], at(j, i), own,
                                other));
    }
}
