package org.auvsim.core.contact;

import static org.auvsim.core.contact.ContactBodies.RESPONSES;
import static org.auvsim.core.contact.ContactBodies.SPEEDS;

/**
 * Rows of contacts without friction whose normals go through both bodies' centres, as between
 * balls: nothing turns.
 */
final class CentralRows extends Rows {
    private static final int AXES = 3;

    /** In a row: the normal, the inverse masses of a and b. */
    private static final int STRIDE = 5;

    private static final int OF_A = 3;
    private static final int OF_B = 4;

    private double[] row = new double[4 * STRIDE];

    CentralRows() {
        super(AXES);
    }

    @Override
    void reserveRows(int capacity) {
        if (j.length < contacts) {
            j = new double[capacity];
            row = new double[capacity * STRIDE];
        }
    }

    @Override
    void write(ContactBodies bodies, Contacts list, int c) {
        int at = rows * STRIDE;
        row[at] = list.nx[c];
        row[at + 1] = list.ny[c];
        row[at + 2] = list.nz[c];
        row[at + OF_A] = bodies.k[RESPONSES * list.a[c]];
        row[at + OF_B] = bodies.k[RESPONSES * list.b[c]];
        double unit = row[at + OF_A] + row[at + OF_B];
        terms[TERMS * c + YIELD] = unit;
        terms[TERMS * c + INVERSE] = unit > 0 ? 1 / unit : 0;
        j[rows++] = unit > 0 ? Math.max(0, list.jn[c]) : 0;
    }

    @Override
    void load(ContactBodies bodies, double[] speeds) {
        for (int k = 0; k < bodies.count; k++) {
            speeds[AXES * k] = bodies.v[SPEEDS * k];
            speeds[AXES * k + 1] = bodies.v[SPEEDS * k + 1];
            speeds[AXES * k + 2] = bodies.v[SPEEDS * k + 2];
        }
    }

    @Override
    void store(double[] speeds, ContactBodies bodies) {
        for (int k = 0; k < bodies.count; k++) {
            bodies.v[SPEEDS * k] = speeds[AXES * k];
            bodies.v[SPEEDS * k + 1] = speeds[AXES * k + 1];
            bodies.v[SPEEDS * k + 2] = speeds[AXES * k + 2];
        }
    }

    @Override
    double speed(int r, double[] v, int a, int b) {
        int at = r * STRIDE;
        return row[at] * (v[a] - v[b])
                + row[at + 1] * (v[a + 1] - v[b + 1])
                + row[at + 2] * (v[a + 2] - v[b + 2]);
    }

    @Override
    void push(int r, double[] v, int a, int b, double impulse) {
        int at = r * STRIDE;
        double ofA = impulse * row[at + OF_A];
        double ofB = impulse * row[at + OF_B];
        double x = row[at];
        double y = row[at + 1];
        double z = row[at + 2];
        v[a] += ofA * x;
        v[a + 1] += ofA * y;
        v[a + 2] += ofA * z;
        v[b] -= ofB * x;
        v[b + 1] -= ofB * y;
        v[b + 2] -= ofB * z;
    }

    @Override
    void push(int r, double[] v, int a, int b, double one, double other) {
        push(r, v, a, b, one);
        push(r + 1, v, a, b, other);
    }

    @Override
    void sum(int r, double[] to, int a, int b, double impulse) {
        int at = r * STRIDE;
        for (int axis = 0; axis < AXES; axis++) {
            to[a + axis] += impulse * row[at + axis];
            to[b + axis] -= impulse * row[at + axis];
        }
    }

    @Override
    double direction(int r, int axis) {
        return row[r * STRIDE + axis];
    }
}
