package org.auvsim.core.contact;

import java.util.Arrays;

/**
 * The equations of the contacts, one row a direction: a contact has a row for its normal and, with
 * friction, two more across it. A row tells what speed along it the bodies have, and what an
 * impulse along it does to them.
 */
abstract class Rows {
    /** Numbers a contact in {@link #terms}. */
    static final int TERMS = 10;

    static final int TARGET = 0;

    /**
     * Speed (m/s) along the normal from a unit impulse along it, and the inverse (0 if it is 0).
     */
    static final int YIELD = 1;

    static final int INVERSE = 2;
    static final int FRICTION = 3;

    /** Inverse of the 2x2 response across the normal: 11, 12, 22. */
    static final int ACROSS = 4;

    /** 1 / larger eigenvalue of that response. */
    static final int STEP = 7;

    /** The speeds across the normal that count as no slip. */
    static final int SLIP = 8;

    /** Numbers of a body's speed. */
    final int speedsABody;

    int contacts;
    int rows;

    /** The impulse along each row (N s). */
    double[] j = new double[4];

    double[] terms = new double[4 * TERMS];

    /** What the sweeps last saw of each contact. */
    boolean[] presses = new boolean[4];

    boolean[] slides = new boolean[4];

    /** First row of each contact and, one past the last, their number. */
    int[] first = new int[4];

    /** Where the speeds of each contact's bodies begin. */
    int[] speedA = new int[4];

    int[] speedB = new int[4];

    Rows(int speedsABody) {
        this.speedsABody = speedsABody;
    }

    /** Makes the rows, and the impulses to start from. */
    final void prepare(ContactBodies bodies, Contacts list) {
        contacts = list.count;
        reserve(list.a.length);
        rows = 0;
        for (int c = 0; c < contacts; c++) {
            first[c] = rows;
            presses[c] = false;
            slides[c] = false;
            speedA[c] = speedsABody * list.a[c];
            speedB[c] = speedsABody * list.b[c];
            terms[TERMS * c + TARGET] = list.target[c];
            terms[TERMS * c + FRICTION] = list.friction[c];
            write(bodies, list, c);
        }
        first[contacts] = rows;
        keepInCone();
    }

    private void reserve(int capacity) {
        if (first.length <= contacts) {
            first = new int[capacity + 1];
            presses = new boolean[capacity + 1];
            slides = new boolean[capacity + 1];
            speedA = new int[capacity + 1];
            speedB = new int[capacity + 1];
            terms = new double[TERMS * (capacity + 1)];
        }
        reserveRows(capacity);
    }

    /** Makes room for the rows of so many contacts. */
    abstract void reserveRows(int capacity);

    /** Writes the next contact: its rows, their guesses and its terms but target and friction. */
    abstract void write(ContactBodies bodies, Contacts list, int c);

    /** Takes the speeds that bodies have. */
    abstract void load(ContactBodies bodies, double[] speeds);

    /** Gives bodies these speeds. */
    abstract void store(double[] speeds, ContactBodies bodies);

    /** How fast the bodies, whose speeds begin at a and b of v, part along a row. */
    abstract double speed(int r, double[] v, int a, int b);

    /** Gives the bodies an impulse along a row. */
    abstract void push(int r, double[] v, int a, int b, double impulse);

    /** Gives the bodies impulses along a row and the next one. */
    abstract void push(int r, double[] v, int a, int b, double one, double other);

    /** Adds what an impulse along a row gives to the bodies' momenta and angular momenta. */
    abstract void sum(int r, double[] to, int a, int b, double impulse);

    /** A component of a row's direction. */
    abstract double direction(int r, int axis);

    /** Whether a contact has rows across its normal. */
    final boolean hasFriction(int contact) {
        return first[contact + 1] > first[contact] + 1;
    }

    /** Whether there is friction, but no guess of any impulse to start from. */
    final boolean isCold() {
        for (int r = 0; r < rows; r++) {
            if (j[r] != 0) {
                return false;
            }
        }
        return rows > contacts;
    }

    /** Takes back what friction has too much, where the last sweep took from the normal impulse. */
    final void keepInCone() {
        for (int c = 0; c < contacts; c++) {
            int r = first[c];
            if (hasFriction(c)) {
                double limit = terms[TERMS * c + FRICTION] * j[r];
                double norm = Math.sqrt(j[r + 1] * j[r + 1] + j[r + 2] * j[r + 2]);
                double share = norm > limit ? limit / norm : 1;
                j[r + 1] *= share;
                j[r + 2] *= share;
            }
        }
    }

    /** Sets speeds to what they are after these impulses. */
    final void apply(double[] impulses, double[] before, double[] speeds, int length) {
        System.arraycopy(before, 0, speeds, 0, length);
        for (int c = 0; c < contacts; c++) {
            for (int r = first[c]; r < first[c + 1]; r++) {
                push(r, speeds, speedA[c], speedB[c], impulses[r]);
            }
        }
    }

    /** Work (J) of impulses that take the bodies from one set of speeds to the other. */
    final double work(double[] impulses, double[] before, double[] after) {
        double work = 0;
        for (int c = 0; c < contacts; c++) {
            int a = speedA[c];
            int b = speedB[c];
            for (int r = first[c]; r < first[c + 1]; r++) {
                double mean = (speed(r, before, a, b) + speed(r, after, a, b)) / 2;
                work += impulses[r] * mean;
            }
        }
        return work;
    }

    /** The fastest wanted change of speed along a normal (m/s). */
    final double fastest(double[] v) {
        double fastest = 0;
        for (int c = 0; c < contacts; c++) {
            double speed = speed(first[c], v, speedA[c], speedB[c]);
            fastest = Math.max(fastest, Math.abs(terms[TERMS * c + TARGET] - speed));
        }
        return fastest;
    }

    /** Hands the impulses to the contacts and their sums to the bodies. */
    final void report(ContactBodies bodies, Contacts list) {
        for (int c = 0; c < contacts; c++) {
            int r = first[c];
            if (hasFriction(c)) {
                list.guess(c, j[r], across(r + 1, 0), across(r + 1, 1), across(r + 1, 2));
            } else {
                list.guess(c, j[r], 0, 0, 0);
            }
        }
        Arrays.fill(bodies.impulse, 0, ContactBodies.SPEEDS * bodies.count, 0);
        int share = ContactBodies.SPEEDS / speedsABody;
        for (int c = 0; c < contacts; c++) {
            for (int r = first[c]; r < first[c + 1]; r++) {
                sum(r, bodies.impulse, share * speedA[c], share * speedB[c], j[r]);
            }
        }
    }

    /** Adds what the impulses give to the bodies' momenta and angular momenta. */
    final void sum(double[] impulses, double[] to) {
        for (int c = 0; c < contacts; c++) {
            for (int r = first[c]; r < first[c + 1]; r++) {
                sum(r, to, speedA[c], speedB[c], impulses[r]);
            }
        }
    }

    /** A component of the impulses along a row and the next one. */
    private double across(int r, int axis) {
        return j[r] * direction(r, axis) + j[r + 1] * direction(r + 1, axis);
    }
}
