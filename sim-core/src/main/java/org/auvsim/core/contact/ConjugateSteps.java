package org.auvsim.core.contact;

import static org.auvsim.core.contact.Rows.FRICTION;
import static org.auvsim.core.contact.Rows.SLIP;
import static org.auvsim.core.contact.Rows.TARGET;
import static org.auvsim.core.contact.Rows.TERMS;
import static org.auvsim.core.contact.Rows.YIELD;

import java.util.Arrays;

/**
 * Makes sweeps converge in about the square root of their number. A pair of sweeps is a step
 * downhill. As long as the same contacts press and none slides, the problem is linear and the step
 * taken leads to the lowest point of the plane through it and the step before (locally optimal
 * conjugate gradients: Knyazev, SIAM J. Sci. Comput. 23, 2001), unless that point is outside the
 * cones. Else a share of the step before is added while the steps get smaller (Silcowitz, Niebuhr
 * &amp; Erleben, The Visual Computer 26, 2010). The sweep after it puts right what is outside.
 */
final class ConjugateSteps {
    /** Below this share of independence, two steps are one. */
    private static final double PARALLEL = 1e-12;

    /**
     * A step longer than so many of the sweeps', or sweeps that correct so much more (in squares)
     * than the first, are no way to a solution: targets that contradict each other have none.
     */
    private static final double TOO_LONG = 100;

    private final Rows rows;
    private double[] oldImpulse = new double[0];
    private double[] impulseStep = new double[0];
    private double[] oldSpeed = new double[0];
    private double[] speedStep = new double[0];

    /** Momentum that the bodies get from the sweeps, and got from the step before. */
    private double[] push = new double[0];

    private double[] pushStep = new double[0];
    private double firstSize;
    private double lastSize;

    /** The step to take: so much of the sweeps' and so much of the one before. */
    private double along;

    private double further;

    ConjugateSteps(Rows rows) {
        this.rows = rows;
    }

    /** Makes ready for bodies with this many speeds, without a step before. */
    void begin(int speeds) {
        if (oldImpulse.length < rows.rows) {
            oldImpulse = new double[rows.j.length];
            impulseStep = new double[rows.j.length];
        }
        if (oldSpeed.length < speeds) {
            oldSpeed = new double[2 * speeds];
            speedStep = new double[2 * speeds];
            push = new double[2 * speeds];
            pushStep = new double[2 * speeds];
        }
        Arrays.fill(impulseStep, 0, rows.rows, 0);
        Arrays.fill(speedStep, 0, speeds, 0);
        Arrays.fill(pushStep, 0, speeds, 0);
        firstSize = 0;
        lastSize = 0;
    }

    /** Remembers where the sweeps set out. */
    void mark(double[] v, int speeds) {
        System.arraycopy(rows.j, 0, oldImpulse, 0, rows.rows);
        System.arraycopy(v, 0, oldSpeed, 0, speeds);
    }

    /**
     * Goes on from where the sweeps came to.
     *
     * @param steady whether each contact pressed and stuck, or not, as in the sweeps before
     */
    void extend(double[] v, int speeds, boolean steady) {
        subtract(rows.j, oldImpulse, rows.rows);
        subtract(v, oldSpeed, speeds);
        Arrays.fill(push, 0, speeds, 0);
        rows.sum(rows.j, push);
        double size = size();
        firstSize = firstSize == 0 ? size : firstSize;
        along = 1;
        further = size < lastSize ? size / lastSize : 0;
        if (size > TOO_LONG * firstSize) {
            further = 0;
        } else if (steady && !slides()) {
            toLowest(v, speeds);
        }
        lastSize = size;
        step(rows.j, oldImpulse, impulseStep, rows.rows);
        step(v, oldSpeed, speedStep, speeds);
        for (int i = 0; i < speeds; i++) {
            pushStep[i] = along * push[i] + further * pushStep[i];
        }
    }

    private static void subtract(double[] from, double[] what, int length) {
        for (int i = 0; i < length; i++) {
            from[i] -= what[i];
        }
    }

    /** Chooses the lowest point; the energy's form is speeds times momenta. */
    private void toLowest(double[] sweepSpeeds, int speeds) {
        double slope = dot(push, oldSpeed, speeds) - aim(rows.j);
        double slopeBefore = dot(pushStep, oldSpeed, speeds) - aim(impulseStep);
        double own = dot(push, sweepSpeeds, speeds);
        double cross = dot(push, speedStep, speeds);
        double before = dot(pushStep, speedStep, speeds);
        double determinant = own * before - cross * cross;
        if (determinant > PARALLEL * own * before) {
            along = (slopeBefore * cross - slope * before) / determinant;
            further = (slope * cross - slopeBefore * own) / determinant;
        } else {
            along = own > 0 ? -slope / own : 1;
            further = 0;
        }
        if (!(Math.abs(along) < TOO_LONG && Math.abs(further) < TOO_LONG) || !staysWithin()) {
            along = 1;
            further = 0;
        }
    }

    private static double dot(double[] a, double[] b, int length) {
        double sum = 0;
        for (int i = 0; i < length; i++) {
            sum += a[i] * b[i];
        }
        return sum;
    }

    private double aim(double[] step) {
        double sum = 0;
        for (int c = 0; c < rows.contacts; c++) {
            int r = rows.first[c];
            sum += rows.terms[TERMS * c + TARGET] * step[r];
            if (rows.hasFriction(c)) {
                sum += rows.terms[TERMS * c + SLIP] * step[r + 1];
                sum += rows.terms[TERMS * c + SLIP + 1] * step[r + 2];
            }
        }
        return sum;
    }

    private boolean slides() {
        for (int c = 0; c < rows.contacts; c++) {
            if (rows.presses[c] && rows.slides[c]) {
                return true;
            }
        }
        return false;
    }

    private boolean staysWithin() {
        for (int c = 0; c < rows.contacts; c++) {
            int r = rows.first[c];
            double normal = after(r);
            if (normal < 0) {
                return false;
            }
            if (rows.hasFriction(c)) {
                double j1 = after(r + 1);
                double j2 = after(r + 2);
                double limit = rows.terms[TERMS * c + FRICTION] * normal;
                if (j1 * j1 + j2 * j2 > limit * limit) {
                    return false;
                }
            }
        }
        return true;
    }

    private double after(int r) {
        return oldImpulse[r] + along * rows.j[r] + further * impulseStep[r];
    }

    /** How much the sweeps changed: squares of impulses, in speed. */
    private double size() {
        double sum = 0;
        for (int c = 0; c < rows.contacts; c++) {
            double squares = 0;
            for (int r = rows.first[c]; r < rows.first[c + 1]; r++) {
                squares += rows.j[r] * rows.j[r];
            }
            sum += rows.terms[TERMS * c + YIELD] * squares;
        }
        return sum;
    }

    private void step(double[] x, double[] old, double[] step, int length) {
        for (int i = 0; i < length; i++) {
            step[i] = along * x[i] + further * step[i];
            x[i] = old[i] + step[i];
        }
    }
}
