package org.auvsim.core.contact;

import static org.auvsim.core.contact.ContactBodies.RESPONSES;
import static org.auvsim.core.contact.ContactBodies.SPEEDS;

import java.util.Arrays;

/**
 * The equations of the contacts, one row a direction: a contact has a row for its normal and, with
 * friction, two more across it. A row holds what speed along it the bodies have, and what an
 * impulse along it does to them.
 */
final class Rows {
    /** In a row: the direction, (r x direction) of a and of b, the response of a and of b. */
    static final int STRIDE = 21;

    private static final int ARM_A = 3;
    private static final int ARM_B = 6;
    private static final int RESPONSE_A = 9;
    private static final int RESPONSE_B = 15;

    /** Numbers a contact in {@link #terms}. */
    static final int TERMS = 8;

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

    /** Below this share of what the bodies could yield at most, a direction is held to be rigid. */
    private static final double RIGID = 1e-14;

    int contacts;
    int rows;
    double[] row = new double[4 * STRIDE];

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

    /** Makes the rows, and the impulses to start from. */
    void prepare(ContactBodies bodies, Contacts list) {
        contacts = list.count;
        reserve(list);
        rows = 0;
        for (int c = 0; c < contacts; c++) {
            first[c] = rows;
            presses[c] = false;
            slides[c] = false;
            speedA[c] = SPEEDS * list.a[c];
            speedB[c] = SPEEDS * list.b[c];
            prepareNormal(bodies, list, c);
            if (list.friction[c] > 0 && terms[TERMS * c + INVERSE] > 0) {
                prepareAcross(bodies, list, c);
            }
        }
        first[contacts] = rows;
        keepInCone();
    }

    private void reserve(Contacts list) {
        if (first.length <= contacts) {
            int size = list.a.length + 1;
            first = new int[size];
            presses = new boolean[size];
            slides = new boolean[size];
            speedA = new int[size];
            speedB = new int[size];
            terms = new double[TERMS * size];
        }
        if (j.length < 3 * contacts) {
            j = new double[3 * list.a.length];
            row = new double[3 * list.a.length * STRIDE];
        }
    }

    private void prepareNormal(ContactBodies bodies, Contacts list, int c) {
        int at = rows * STRIDE;
        write(bodies, list, c, list.nx[c], list.ny[c], list.nz[c]);
        double unit = speedFrom(at, at);
        boolean rigid =
                unit
                        <= RIGID
                                * (most(bodies, list, c, list.a[c])
                                        + most(bodies, list, c, list.b[c]));
        int term = TERMS * c;
        terms[term + TARGET] = list.target[c];
        terms[term + YIELD] = unit;
        terms[term + INVERSE] = rigid ? 0 : 1 / unit;
        terms[term + FRICTION] = list.friction[c];
        j[rows - 1] = rigid ? 0 : Math.max(0, list.jn[c]);
    }

    /** An upper bound of what a body can yield at a contact, in any direction (1/kg). */
    private static double most(ContactBodies bodies, Contacts list, int c, int body) {
        double rx = list.px[c] - bodies.x[3 * body];
        double ry = list.py[c] - bodies.x[3 * body + 1];
        double rz = list.pz[c] - bodies.x[3 * body + 2];
        double[] k = bodies.k;
        int at = RESPONSES * body;
        double linear = k[at] + k[at + 7] + k[at + 14];
        double angular = k[at + 21] + k[at + 28] + k[at + 35];
        return 2 * (linear + (rx * rx + ry * ry + rz * rz) * angular);
    }

    private void prepareAcross(ContactBodies bodies, Contacts list, int c) {
        double nx = list.nx[c];
        double ny = list.ny[c];
        double nz = list.nz[c];
        // Across the normal and the axis that is farthest from it: well conditioned for any normal.
        double ux = 0;
        double uy = 0;
        double uz = 0;
        if (Math.abs(nx) <= Math.abs(ny) && Math.abs(nx) <= Math.abs(nz)) {
            uy = nz;
            uz = -ny;
        } else if (Math.abs(ny) <= Math.abs(nz)) {
            ux = -nz;
            uz = nx;
        } else {
            ux = ny;
            uy = -nx;
        }
        double norm = Math.sqrt(ux * ux + uy * uy + uz * uz);
        ux /= norm;
        uy /= norm;
        uz /= norm;
        write(bodies, list, c, ux, uy, uz);
        write(bodies, list, c, ny * uz - nz * uy, nz * ux - nx * uz, nx * uy - ny * ux);
        invertAcross(TERMS * c, (rows - 2) * STRIDE);
        guessAcross(list, c);
    }

    private void invertAcross(int term, int at) {
        double k11 = speedFrom(at, at);
        double k12 = speedFrom(at, at + STRIDE);
        double k22 = speedFrom(at + STRIDE, at + STRIDE);
        double mean = (k11 + k22) / 2;
        double half = (k11 - k22) / 2;
        double largest = mean + Math.sqrt(half * half + k12 * k12);
        double determinant = k11 * k22 - k12 * k12;
        boolean singular = determinant <= RIGID * mean * mean;
        double step = largest > 0 ? 1 / largest : 0;
        terms[term + ACROSS] = singular ? step : k22 / determinant;
        terms[term + ACROSS + 1] = singular ? 0 : -k12 / determinant;
        terms[term + ACROSS + 2] = singular ? step : k11 / determinant;
        terms[term + STEP] = step;
    }

    private void guessAcross(Contacts list, int c) {
        j[rows - 2] = dot(list, c, rows - 2);
        j[rows - 1] = dot(list, c, rows - 1);
    }

    private double dot(Contacts list, int c, int number) {
        int at = number * STRIDE;
        return list.jx[c] * row[at] + list.jy[c] * row[at + 1] + list.jz[c] * row[at + 2];
    }

    /** Writes the next row, of a direction (x, y, z). */
    private void write(ContactBodies bodies, Contacts list, int c, double x, double y, double z) {
        int at = rows * STRIDE;
        row[at] = x;
        row[at + 1] = y;
        row[at + 2] = z;
        writeBody(bodies, list, c, list.a[c], at, ARM_A, RESPONSE_A);
        writeBody(bodies, list, c, list.b[c], at, ARM_B, RESPONSE_B);
        rows++;
    }

    private void writeBody(
            ContactBodies bodies, Contacts list, int c, int body, int at, int arm, int response) {
        double rx = list.px[c] - bodies.x[3 * body];
        double ry = list.py[c] - bodies.x[3 * body + 1];
        double rz = list.pz[c] - bodies.x[3 * body + 2];
        double x = row[at];
        double y = row[at + 1];
        double z = row[at + 2];
        double ax = ry * z - rz * y;
        double ay = rz * x - rx * z;
        double az = rx * y - ry * x;
        row[at + arm] = ax;
        row[at + arm + 1] = ay;
        row[at + arm + 2] = az;
        double[] k = bodies.k;
        for (int i = 0; i < SPEEDS; i++) {
            int line = RESPONSES * body + SPEEDS * i;
            row[at + response + i] =
                    (k[line] * x + k[line + 1] * y + k[line + 2] * z)
                            + (k[line + 3] * ax + k[line + 4] * ay + k[line + 5] * az);
        }
    }

    /** Speed along one row from a unit impulse along another of the same contact. */
    private double speedFrom(int at, int other) {
        return speedFrom(at, ARM_A, other + RESPONSE_A) + speedFrom(at, ARM_B, other + RESPONSE_B);
    }

    private double speedFrom(int at, int arm, int response) {
        return (row[at] * row[response]
                        + row[at + 1] * row[response + 1]
                        + row[at + 2] * row[response + 2])
                + (row[at + arm] * row[response + 3]
                        + row[at + arm + 1] * row[response + 4]
                        + row[at + arm + 2] * row[response + 5]);
    }

    /**
     * How fast the bodies, whose speeds begin at a and b of v, part along the row at {@code at}.
     */
    static double speed(double[] row, int at, double[] v, int a, int b) {
        double linear =
                row[at] * (v[a] - v[b])
                        + row[at + 1] * (v[a + 1] - v[b + 1])
                        + row[at + 2] * (v[a + 2] - v[b + 2]);
        double ofA =
                row[at + ARM_A] * v[a + 3]
                        + row[at + ARM_A + 1] * v[a + 4]
                        + row[at + ARM_A + 2] * v[a + 5];
        double ofB =
                row[at + ARM_B] * v[b + 3]
                        + row[at + ARM_B + 1] * v[b + 4]
                        + row[at + ARM_B + 2] * v[b + 5];
        return linear + (ofA - ofB);
    }

    /** Gives the bodies an impulse along the row at {@code at}. */
    static void push(double[] row, int at, double[] v, int a, int b, double impulse) {
        v[a] += impulse * row[at + RESPONSE_A];
        v[a + 1] += impulse * row[at + RESPONSE_A + 1];
        v[a + 2] += impulse * row[at + RESPONSE_A + 2];
        v[a + 3] += impulse * row[at + RESPONSE_A + 3];
        v[a + 4] += impulse * row[at + RESPONSE_A + 4];
        v[a + 5] += impulse * row[at + RESPONSE_A + 5];
        v[b] -= impulse * row[at + RESPONSE_B];
        v[b + 1] -= impulse * row[at + RESPONSE_B + 1];
        v[b + 2] -= impulse * row[at + RESPONSE_B + 2];
        v[b + 3] -= impulse * row[at + RESPONSE_B + 3];
        v[b + 4] -= impulse * row[at + RESPONSE_B + 4];
        v[b + 5] -= impulse * row[at + RESPONSE_B + 5];
    }

    /** Whether there is friction, but no guess of any impulse to start from. */
    boolean isCold() {
        for (int r = 0; r < rows; r++) {
            if (j[r] != 0) {
                return false;
            }
        }
        return rows > contacts;
    }

    /** Takes back what friction has too much, where the last sweep took from the normal impulse. */
    void keepInCone() {
        for (int c = 0; c < contacts; c++) {
            int r = first[c];
            if (first[c + 1] > r + 1) {
                double limit = terms[TERMS * c + FRICTION] * j[r];
                double norm = Math.sqrt(j[r + 1] * j[r + 1] + j[r + 2] * j[r + 2]);
                double share = norm > limit ? limit / norm : 1;
                j[r + 1] *= share;
                j[r + 2] *= share;
            }
        }
    }

    /** Gives the bodies impulses along the row at {@code at} and the next one. */
    static void push(double[] row, int at, double[] v, int a, int b, double one, double other) {
        int second = at + STRIDE;
        v[a] += one * row[at + RESPONSE_A] + other * row[second + RESPONSE_A];
        v[a + 1] += one * row[at + RESPONSE_A + 1] + other * row[second + RESPONSE_A + 1];
        v[a + 2] += one * row[at + RESPONSE_A + 2] + other * row[second + RESPONSE_A + 2];
        v[a + 3] += one * row[at + RESPONSE_A + 3] + other * row[second + RESPONSE_A + 3];
        v[a + 4] += one * row[at + RESPONSE_A + 4] + other * row[second + RESPONSE_A + 4];
        v[a + 5] += one * row[at + RESPONSE_A + 5] + other * row[second + RESPONSE_A + 5];
        v[b] -= one * row[at + RESPONSE_B] + other * row[second + RESPONSE_B];
        v[b + 1] -= one * row[at + RESPONSE_B + 1] + other * row[second + RESPONSE_B + 1];
        v[b + 2] -= one * row[at + RESPONSE_B + 2] + other * row[second + RESPONSE_B + 2];
        v[b + 3] -= one * row[at + RESPONSE_B + 3] + other * row[second + RESPONSE_B + 3];
        v[b + 4] -= one * row[at + RESPONSE_B + 4] + other * row[second + RESPONSE_B + 4];
        v[b + 5] -= one * row[at + RESPONSE_B + 5] + other * row[second + RESPONSE_B + 5];
    }

    /** Sets speeds to what they are after these impulses. */
    void apply(double[] impulses, double[] before, double[] speeds, int length) {
        System.arraycopy(before, 0, speeds, 0, length);
        for (int c = 0; c < contacts; c++) {
            for (int r = first[c]; r < first[c + 1]; r++) {
                push(row, r * STRIDE, speeds, speedA[c], speedB[c], impulses[r]);
            }
        }
    }

    /** Work (J) of impulses that take the bodies from one set of speeds to the other. */
    double work(double[] impulses, double[] before, double[] after) {
        double work = 0;
        for (int c = 0; c < contacts; c++) {
            int a = speedA[c];
            int b = speedB[c];
            for (int r = first[c]; r < first[c + 1]; r++) {
                int at = r * STRIDE;
                double mean = (speed(row, at, before, a, b) + speed(row, at, after, a, b)) / 2;
                work += impulses[r] * mean;
            }
        }
        return work;
    }

    /** The fastest wanted change of speed along a normal (m/s). */
    double fastest(double[] v) {
        double fastest = 0;
        for (int c = 0; c < contacts; c++) {
            double speed = speed(row, first[c] * STRIDE, v, speedA[c], speedB[c]);
            fastest = Math.max(fastest, Math.abs(terms[TERMS * c + TARGET] - speed));
        }
        return fastest;
    }

    /** Hands the impulses to the contacts and their sums to the bodies. */
    void report(ContactBodies bodies, Contacts list) {
        Arrays.fill(bodies.impulse, 0, SPEEDS * bodies.count, 0);
        for (int c = 0; c < contacts; c++) {
            int r = first[c];
            boolean across = first[c + 1] > r + 1;
            list.guess(c, j[r], across(r, 0, across), across(r, 1, across), across(r, 2, across));
        }
        sum(j, bodies.impulse);
    }

    /** Adds what the impulses give to the bodies' momenta and angular momenta. */
    void sum(double[] impulses, double[] to) {
        for (int c = 0; c < contacts; c++) {
            for (int r = first[c]; r < first[c + 1]; r++) {
                sum(to, speedA[c], r * STRIDE, ARM_A, impulses[r]);
                sum(to, speedB[c], r * STRIDE, ARM_B, -impulses[r]);
            }
        }
    }

    private double across(int normal, int axis, boolean present) {
        if (!present) {
            return 0;
        }
        return j[normal + 1] * row[(normal + 1) * STRIDE + axis]
                + j[normal + 2] * row[(normal + 2) * STRIDE + axis];
    }

    private void sum(double[] to, int body, int at, int arm, double impulse) {
        to[body] += impulse * row[at];
        to[body + 1] += impulse * row[at + 1];
        to[body + 2] += impulse * row[at + 2];
        to[body + 3] += impulse * row[at + arm];
        to[body + 4] += impulse * row[at + arm + 1];
        to[body + 5] += impulse * row[at + arm + 2];
    }
}
