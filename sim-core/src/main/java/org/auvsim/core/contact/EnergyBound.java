package org.auvsim.core.contact;

import static org.auvsim.core.contact.Rows.TARGET;
import static org.auvsim.core.contact.Rows.TERMS;

/**
 * Keeps impacts from adding kinetic energy. The impulses that merely stop the bodies (targets 0)
 * never add any: they push without bouncing, and friction opposes the slip. Between those and the
 * bouncing ones the energy is a parabola; its root is the most bounce that there is energy for.
 * Both ends keep the bodies apart and within the friction cone, and so does what lies between.
 */
final class EnergyBound {
    /** A gain below this share of the work done against the approach is the iteration's error. */
    private static final double SLIGHT = 1e-8;

    private final Rows rows;
    private double[] bouncing = new double[0];

    EnergyBound(Rows rows) {
        this.rows = rows;
    }

    /**
     * Whether what was gained on the way from one set of speeds to the other is an error's size.
     */
    boolean isSlight(double[] before, double[] after) {
        double approach = rows.work(rows.j, before, before);
        return rows.work(rows.j, before, after) <= -SLIGHT * approach;
    }

    /** Keeps the impulses, and makes the rows ask for those that merely stop. */
    void keepBouncing() {
        if (bouncing.length < rows.rows) {
            bouncing = new double[rows.j.length];
        }
        System.arraycopy(rows.j, 0, bouncing, 0, rows.rows);
        for (int r = 0; r < rows.rows; r++) {
            rows.j[r] = 0;
        }
        for (int c = 0; c < rows.contacts; c++) {
            int target = TERMS * c + TARGET;
            rows.terms[target] = Math.min(0, rows.terms[target]);
        }
    }

    /**
     * Adds as much of the kept impulses as there is energy for, to those now in the rows.
     *
     * @return the share that was added
     */
    double blend(double[] before, double[] v, int speeds) {
        double none = rows.work(rows.j, before, v);
        for (int r = 0; r < rows.rows; r++) {
            bouncing[r] -= rows.j[r];
        }
        double half = workWith(0.5, before, v, speeds);
        double all = workWith(0.5, before, v, speeds);
        double share = root(none, -3 * none + 4 * half - all, 2 * none - 4 * half + 2 * all);
        workWith(share - 1, before, v, speeds);
        return share;
    }

    /** Adds a share of the kept impulses, and gives the work of the sum. */
    private double workWith(double share, double[] before, double[] v, int speeds) {
        for (int r = 0; r < rows.rows; r++) {
            rows.j[r] += share * bouncing[r];
        }
        rows.apply(rows.j, before, v, speeds);
        return rows.work(rows.j, before, v);
    }

    /** Where c + b s + a s^2, 0 or less at s = 0 and convex, comes to 0; between 0 and 1. */
    private static double root(double c, double b, double a) {
        double d = Math.sqrt(Math.max(0, b * b - 4 * a * c));
        double root = b > 0 ? -2 * c / (b + d) : a > 0 ? (d - b) / (2 * a) : 1;
        return Math.min(1, Math.max(0, root));
    }

    /**
     * Makes all impulses smaller by the factor that takes away what gain is left.
     *
     * @return the gain (J), 0 or less
     */
    double scale(double[] before, double[] v, int speeds) {
        double gain = rows.work(rows.j, before, v);
        if (gain <= 0) {
            return gain;
        }
        double approach = rows.work(rows.j, before, before);
        double factor = approach < 0 ? approach / (approach - gain) : 0;
        for (int r = 0; r < rows.rows; r++) {
            rows.j[r] *= factor;
        }
        rows.apply(rows.j, before, v, speeds);
        return Math.min(0, rows.work(rows.j, before, v));
    }
}
