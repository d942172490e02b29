package org.auvsim.core.contact;

import static org.auvsim.core.contact.Rows.ACROSS;
import static org.auvsim.core.contact.Rows.FRICTION;
import static org.auvsim.core.contact.Rows.INVERSE;
import static org.auvsim.core.contact.Rows.SLIP;
import static org.auvsim.core.contact.Rows.STEP;
import static org.auvsim.core.contact.Rows.TARGET;
import static org.auvsim.core.contact.Rows.TERMS;
import static org.auvsim.core.contact.Rows.YIELD;

/**
 * Projected Gauss-Seidel: each contact in turn gets what its two bodies need just now, within
 * Coulomb's cone (Jean 1999; Catto 2005). A sweep returns the largest correction (m/s) it made.
 */
final class Sweep {
    private final Rows rows;

    /** Whether friction is left out. */
    private boolean smooth;

    /** Whether each contact pressed and stuck, or not, as in the sweep before. */
    private boolean steady;

    Sweep(Rows rows) {
        this.rows = rows;
    }

    /** Leaves friction out, or not. */
    void setSmooth(boolean smooth) {
        this.smooth = smooth;
    }

    /** Whether in the last two sweeps each contact pressed and stuck, or not, as before. */
    boolean isSteady() {
        return steady;
    }

    /** From the first contact to the last. */
    double forward(double[] v) {
        steady = true;
        double most = 0;
        int count = rows.contacts;
        for (int c = 0; c < count; c++) {
            most = Math.max(most, normal(c, v));
            if (!smooth && rows.hasFriction(c)) {
                most = Math.max(most, across(c, v));
            }
        }
        return most;
    }

    /** The same in the opposite order, so that both together favour no end of a chain. */
    double backward(double[] v) {
        double most = 0;
        for (int c = rows.contacts - 1; c >= 0; c--) {
            if (!smooth && rows.hasFriction(c)) {
                most = Math.max(most, across(c, v));
            }
            most = Math.max(most, normal(c, v));
        }
        return most;
    }

    private double normal(int c, double[] v) {
        double[] terms = rows.terms;
        double[] j = rows.j;
        int term = TERMS * c;
        int r = rows.first[c];
        int a = rows.speedA[c];
        int b = rows.speedB[c];
        double speed = rows.speed(r, v, a, b);
        double old = j[r];
        double now = Math.max(0, old + (terms[term + TARGET] - speed) * terms[term + INVERSE]);
        j[r] = now;
        steady &= rows.presses[c] == now > 0;
        rows.presses[c] = now > 0;
        if (now == old) {
            return 0;
        }
        rows.push(r, v, a, b, now - old);
        return Math.abs(now - old) * terms[term + YIELD];
    }

    /**
     * Stops the slip, if the cone allows that; else goes a step down the slope of the kinetic
     * energy and back to the cone's edge, whose fixed point is friction straight against the slip,
     * however the bodies' response depends on direction.
     */
    private double across(int c, double[] v) {
        double[] terms = rows.terms;
        double[] j = rows.j;
        int term = TERMS * c;
        int r = rows.first[c];
        int a = rows.speedA[c];
        int b = rows.speedB[c];
        double s1 = rows.speed(r + 1, v, a, b) - terms[term + SLIP];
        double s2 = rows.speed(r + 2, v, a, b) - terms[term + SLIP + 1];
        double limit = terms[term + FRICTION] * j[r];
        double old1 = j[r + 1];
        double old2 = j[r + 2];
        double j1 = old1 - terms[term + ACROSS] * s1 - terms[term + ACROSS + 1] * s2;
        double j2 = old2 - terms[term + ACROSS + 1] * s1 - terms[term + ACROSS + 2] * s2;
        boolean slides = j1 * j1 + j2 * j2 > limit * limit;
        steady &= rows.slides[c] == slides;
        rows.slides[c] = slides;
        if (slides) {
            j1 = old1 - terms[term + STEP] * s1;
            j2 = old2 - terms[term + STEP] * s2;
            double norm = Math.sqrt(j1 * j1 + j2 * j2);
            if (norm > limit) {
                j1 *= limit / norm;
                j2 *= limit / norm;
            }
        }
        j[r + 1] = j1;
        j[r + 2] = j2;
        rows.push(r + 1, v, a, b, j1 - old1, j2 - old2);
        double step = terms[term + STEP];
        return step == 0 ? 0 : Math.max(Math.abs(j1 - old1), Math.abs(j2 - old2)) / step;
    }
}
