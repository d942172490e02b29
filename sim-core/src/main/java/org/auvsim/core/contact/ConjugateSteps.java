package org.auvsim.core.contact;

import static org.auvsim.core.contact.Rows.TERMS;
import static org.auvsim.core.contact.Rows.YIELD;

import java.util.Arrays;

/**
 * Makes sweeps converge in about the square root of their number: each pair of sweeps is taken for
 * the gradient of a conjugate-gradient step (Silcowitz, Niebuhr &amp; Erleben, A nonsmooth
 * nonlinear conjugate gradient method for interactive contact force problems, The Visual Computer
 * 26, 2010).
 */
final class ConjugateSteps {
    private final Rows rows;
    private double[] oldImpulse = new double[0];
    private double[] impulseStep = new double[0];
    private double[] oldSpeed = new double[0];
    private double[] speedStep = new double[0];
    private double lastGradient;

    ConjugateSteps(Rows rows) {
        this.rows = rows;
    }

    /** Makes ready for bodies with this many speeds. */
    void begin(int speeds) {
        if (oldImpulse.length < rows.rows) {
            oldImpulse = new double[rows.j.length];
            impulseStep = new double[rows.j.length];
        }
        if (oldSpeed.length < speeds) {
            oldSpeed = new double[2 * speeds];
            speedStep = new double[2 * speeds];
        }
        Arrays.fill(impulseStep, 0, rows.rows, 0);
        Arrays.fill(speedStep, 0, speeds, 0);
        lastGradient = 0;
    }

    /** Remembers where the sweeps set out. */
    void mark(double[] v, int speeds) {
        System.arraycopy(rows.j, 0, oldImpulse, 0, rows.rows);
        System.arraycopy(v, 0, oldSpeed, 0, speeds);
    }

    /** Goes on from where the sweeps came to, along the step before. */
    void extend(double[] v, int speeds) {
        double gradient = gradient();
        double share = lastGradient > 0 ? gradient / lastGradient : 0;
        lastGradient = gradient;
        // A gradient that grows: the set of pressed contacts has changed. Start anew.
        double further = share < 1 ? share : 0;
        step(rows.j, oldImpulse, impulseStep, further, rows.rows);
        step(v, oldSpeed, speedStep, further, speeds);
    }

    private double gradient() {
        double sum = 0;
        for (int c = 0; c < rows.contacts; c++) {
            double squares = 0;
            for (int r = rows.first[c]; r < rows.first[c + 1]; r++) {
                double d = rows.j[r] - oldImpulse[r];
                squares += d * d;
            }
            sum += rows.terms[TERMS * c + YIELD] * squares;
        }
        return sum;
    }

    private static void step(double[] x, double[] old, double[] step, double further, int length) {
        for (int i = 0; i < length; i++) {
            double next = x[i] + further * step[i];
            step[i] = next - old[i];
            x[i] = next;
        }
    }
}
