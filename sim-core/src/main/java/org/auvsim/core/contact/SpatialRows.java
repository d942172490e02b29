package org.auvsim.core.contact;

import static org.auvsim.core.contact.ContactBodies.RESPONSES;
import static org.auvsim.core.contact.ContactBodies.SPEEDS;

/** Rows of bodies that move and turn. */
final class SpatialRows extends Rows {
    /** In a row: the direction, (r x direction) of a and of b, the response of a and of b. */
    private static final int STRIDE = 21;

    private static final int ARM_A = 3;
    private static final int ARM_B = 6;
    private static final int RESPONSE_A = 9;
    private static final int RESPONSE_B = 15;

    /** Below this share of what the bodies could yield at most, a direction is held to be rigid. */
    private static final double RIGID = 1e-14;

    private double[] row = new double[4 * STRIDE];

    SpatialRows() {
        super(SPEEDS);
    }

    @Override
    void reserveRows(int capacity) {
        if (j.length < 3 * contacts) {
            j = new double[3 * capacity];
            row = new double[3 * capacity * STRIDE];
        }
    }

    @Override
    void load(ContactBodies bodies, double[] speeds) {
        System.arraycopy(bodies.v, 0, speeds, 0, SPEEDS * bodies.count);
    }

    @Override
    void store(double[] speeds, ContactBodies bodies) {
        System.arraycopy(speeds, 0, bodies.v, 0, SPEEDS * bodies.count);
    }

    @Override
    void write(ContactBodies bodies, Contacts list, int c) {
        writeNormal(bodies, list, c);
        if (list.friction[c] > 0 && terms[TERMS * c + INVERSE] > 0) {
            writeAcross(bodies, list, c);
        }
    }

    private void writeNormal(ContactBodies bodies, Contacts list, int c) {
        int at = rows * STRIDE;
        write(bodies, list, c, list.nx[c], list.ny[c], list.nz[c]);
        double unit = speedFrom(at, at);
        double most = most(bodies, list, c, list.a[c]) + most(bodies, list, c, list.b[c]);
        boolean rigid = unit <= RIGID * most;
        int term = TERMS * c;
        terms[term + YIELD] = unit;
        terms[term + INVERSE] = rigid ? 0 : 1 / unit;
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

    private void writeAcross(ContactBodies bodies, Contacts list, int c) {
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
        for (int i = 0; i < 2; i++) {
            int r = rows - 2 + i;
            j[r] = along(r, list.jx[c], list.jy[c], list.jz[c]);
            terms[TERMS * c + SLIP + i] = along(r, list.slipX[c], list.slipY[c], list.slipZ[c]);
        }
    }

    private double along(int r, double x, double y, double z) {
        int at = r * STRIDE;
        return x * row[at] + y * row[at + 1] + z * row[at + 2];
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

    @Override
    double speed(int r, double[] v, int a, int b) {
        int at = r * STRIDE;
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

    @Override
    void push(int r, double[] v, int a, int b, double impulse) {
        int at = r * STRIDE;
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

    @Override
    void push(int r, double[] v, int a, int b, double one, double other) {
        int at = r * STRIDE;
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

    @Override
    void sum(int r, double[] to, int a, int b, double impulse) {
        sum(to, a, r * STRIDE, ARM_A, impulse);
        sum(to, b, r * STRIDE, ARM_B, -impulse);
    }

    private void sum(double[] to, int body, int at, int arm, double impulse) {
        to[body] += impulse * row[at];
        to[body + 1] += impulse * row[at + 1];
        to[body + 2] += impulse * row[at + 2];
        to[body + 3] += impulse * row[at + arm];
        to[body + 4] += impulse * row[at + arm + 1];
        to[body + 5] += impulse * row[at + arm + 2];
    }

    @Override
    double direction(int r, int axis) {
        return row[r * STRIDE + axis];
    }
}
