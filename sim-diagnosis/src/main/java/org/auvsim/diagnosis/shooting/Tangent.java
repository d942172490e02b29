package org.auvsim.diagnosis.shooting;

import org.auvsim.diagnosis.shooting.WindowDerivatives.Moves;
import org.auvsim.server.feedback.RigidMotion;

/**
 * Derivatives of a window, and where they were taken. Elsewhere they do as well, as long as what
 * the window misses there is what they foretold (simplified Newton steps: Deuflhard, Newton Methods
 * for Nonlinear Problems, 2004, section 2.1).
 */
public final class Tangent {
    /** Square of the share of a change by which what was foretold of it may be off. */
    private static final double MOST_OFF = 0.01;

    private final WindowDerivatives taken;
    private final double[] numbers;
    private final WindowDerivatives here;

    /** Square of what was foretold wrong, in standard deviations. */
    private final double off;

    private Tangent(WindowDerivatives taken, double[] numbers, WindowDerivatives here, double off) {
        this.taken = taken;
        this.numbers = numbers;
        this.here = here;
        this.off = off;
    }

    /**
     * Taken where a window is.
     *
     * @param motion in the window
     * @param numbers parameters of the causes, which are moved
     */
    public static Tangent of(
            Shooting shooting, Window window, RigidMotion[] motion, Moves moves, double[] numbers) {
        WindowDerivatives taken = shooting.derivatives(window, motion, 1, moves);
        return new Tangent(taken, numbers, taken, 0);
    }

    /** Where the same window is elsewhere: as it is, if it foretold what is missed there. */
    public Tangent at(
            Shooting shooting, Window window, RigidMotion[] motion, Moves moves, double[] there) {
        double[] misses = shooting.misses(window, motion);
        double wrong = squares(misses, foretold(window.start(), there));
        return wrong <= MOST_OFF * squares(misses, taken.misses)
                ? new Tangent(taken, numbers, here.at(window, motion, misses), wrong)
                : of(shooting, window, motion, moves, there);
    }

    private double[] foretold(RigidMotion start, double[] there) {
        double[] foretold = taken.misses.clone();
        double[] moved = start.minus(taken.window.start());
        for (int i = 0; i < moved.length; i++) {
            add(moved[i], taken.byStart[i], foretold);
        }
        for (int p = 0; p < there.length; p++) {
            add(there[p] - numbers[p], taken.byParameter[p], foretold);
        }
        return foretold;
    }

    private static void add(double factor, double[] column, double[] sum) {
        for (int k = 0; k < sum.length; k++) {
            sum[k] += factor * column[k];
        }
    }

    private static double squares(double[] one, double[] other) {
        double sum = 0;
        for (int k = 0; k < one.length; k++) {
            sum += (one[k] - other[k]) * (one[k] - other[k]);
        }
        return sum;
    }

    /** The derivatives here. */
    public WindowDerivatives derivatives() {
        return here;
    }

    /** By what squares (of standard deviations) they foretold wrongly what is missed here. */
    public double off() {
        return off;
    }
}
