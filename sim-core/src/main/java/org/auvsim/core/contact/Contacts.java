package org.auvsim.core.contact;

import static org.auvsim.core.contact.ContactBodies.SPEEDS;

import java.util.Arrays;

/**
 * The points where bodies of one island touch, in the order in which they were added, which is the
 * order in which they are solved. Made to be cleared and filled again: it allocates only when it
 * has never held so many.
 */
public final class Contacts {
    /** How many there are. */
    public int count;

    /** The two bodies, by their index in {@link ContactBodies}. */
    public int[] a = new int[4];

    /** The two bodies, by their index in {@link ContactBodies}. */
    public int[] b = new int[4];

    /** The point (m, world). */
    public double[] px = new double[4];

    /** The point (m, world). */
    public double[] py = new double[4];

    /** The point (m, world). */
    public double[] pz = new double[4];

    /** Unit normal from b to a (world). */
    public double[] nx = new double[4];

    /** Unit normal from b to a (world). */
    public double[] ny = new double[4];

    /** Unit normal from b to a (world). */
    public double[] nz = new double[4];

    /** Coulomb's coefficient, 0 or more. */
    public double[] friction = new double[4];

    /** Least speed (m/s) at which a and b are to part afterwards. */
    public double[] target = new double[4];

    /**
     * Slip (m/s, world) of a against b across the normal that counts as none: what friction works
     * against is the difference. What lies along the normal does not matter.
     */
    public double[] slipX = new double[4];

    /** Slip that counts as none. */
    public double[] slipY = new double[4];

    /** Slip that counts as none. */
    public double[] slipZ = new double[4];

    /** Impulse along the normal (N s) on a, 0 or more: read as a first guess, written as answer. */
    public double[] jn = new double[4];

    /** Friction's impulse (N s, world) on a, across the normal: read and written as {@link #jn}. */
    public double[] jx = new double[4];

    /** Friction's impulse (N s, world) on a, across the normal: read and written as {@link #jn}. */
    public double[] jy = new double[4];

    /** Friction's impulse (N s, world) on a, across the normal: read and written as {@link #jn}. */
    public double[] jz = new double[4];

    /**
     * Whether the contact has no friction and a normal through both bodies' origins, which are
     * their centres of mass: it turns neither.
     */
    public boolean[] isCentral = new boolean[4];

    /** Forgets all contacts. */
    public void clear() {
        count = 0;
    }

    /** Whether all contacts are central. */
    public boolean areCentral() {
        for (int c = 0; c < count; c++) {
            if (!isCentral[c]) {
                return false;
            }
        }
        return true;
    }

    /**
     * Adds a contact without friction, to be stopped (target 0), with impulses of 0; set the other
     * columns to change that.
     *
     * @return its index
     */
    public int add(
            int bodyA,
            int bodyB,
            double pointX,
            double pointY,
            double pointZ,
            double normalX,
            double normalY,
            double normalZ) {
        if (count == a.length) {
            grow();
        }
        int c = count++;
        a[c] = bodyA;
        b[c] = bodyB;
        px[c] = pointX;
        py[c] = pointY;
        pz[c] = pointZ;
        nx[c] = normalX;
        ny[c] = normalY;
        nz[c] = normalZ;
        friction[c] = 0;
        target[c] = 0;
        isCentral[c] = false;
        slip(c, 0, 0, 0);
        guess(c, 0, 0, 0, 0);
        return c;
    }

    /** Sets the impulses that the solver starts from: those of an earlier frame, or zeros. */
    public void guess(int contact, double normal, double alongX, double alongY, double alongZ) {
        jn[contact] = normal;
        jx[contact] = alongX;
        jy[contact] = alongY;
        jz[contact] = alongZ;
    }

    /** Sets the slip (m/s, world) that counts as none. */
    public void slip(int contact, double alongX, double alongY, double alongZ) {
        slipX[contact] = alongX;
        slipY[contact] = alongY;
        slipZ[contact] = alongZ;
    }

    /** How fast a and b part at a contact, along the normal (m/s); negative: they approach. */
    public double separationSpeed(int contact, ContactBodies bodies) {
        return along(contact, a[contact], bodies) - along(contact, b[contact], bodies);
    }

    /**
     * Writes the velocity (m/s, world) of a's material against b's at a contact, in all directions.
     */
    public void relativeVelocity(int contact, ContactBodies bodies, double[] to, int at) {
        double[] v = bodies.v;
        double[] x = bodies.x;
        int one = a[contact];
        int other = b[contact];
        int p = SPEEDS * one;
        int q = SPEEDS * other;
        double ax = px[contact] - x[3 * one];
        double ay = py[contact] - x[3 * one + 1];
        double az = pz[contact] - x[3 * one + 2];
        double bx = px[contact] - x[3 * other];
        double by = py[contact] - x[3 * other + 1];
        double bz = pz[contact] - x[3 * other + 2];
        to[at] = (v[p] + v[p + 4] * az - v[p + 5] * ay) - (v[q] + v[q + 4] * bz - v[q + 5] * by);
        to[at + 1] =
                (v[p + 1] + v[p + 5] * ax - v[p + 3] * az)
                        - (v[q + 1] + v[q + 5] * bx - v[q + 3] * bz);
        to[at + 2] =
                (v[p + 2] + v[p + 3] * ay - v[p + 4] * ax)
                        - (v[q + 2] + v[q + 3] * by - v[q + 4] * bx);
    }

    /** Speed (m/s) along the normal of a body's material at the contact point. */
    private double along(int c, int body, ContactBodies bodies) {
        double[] v = bodies.v;
        int at = SPEEDS * body;
        if (isCentral[c]) {
            return nx[c] * v[at] + ny[c] * v[at + 1] + nz[c] * v[at + 2];
        }
        double rx = px[c] - bodies.x[3 * body];
        double ry = py[c] - bodies.x[3 * body + 1];
        double rz = pz[c] - bodies.x[3 * body + 2];
        return nx[c] * (v[at] + v[at + 4] * rz - v[at + 5] * ry)
                + ny[c] * (v[at + 1] + v[at + 5] * rx - v[at + 3] * rz)
                + nz[c] * (v[at + 2] + v[at + 3] * ry - v[at + 4] * rx);
    }

    private void grow() {
        int size = 2 * count;
        a = Arrays.copyOf(a, size);
        b = Arrays.copyOf(b, size);
        px = Arrays.copyOf(px, size);
        py = Arrays.copyOf(py, size);
        pz = Arrays.copyOf(pz, size);
        nx = Arrays.copyOf(nx, size);
        ny = Arrays.copyOf(ny, size);
        nz = Arrays.copyOf(nz, size);
        friction = Arrays.copyOf(friction, size);
        target = Arrays.copyOf(target, size);
        isCentral = Arrays.copyOf(isCentral, size);
        slipX = Arrays.copyOf(slipX, size);
        slipY = Arrays.copyOf(slipY, size);
        slipZ = Arrays.copyOf(slipZ, size);
        jn = Arrays.copyOf(jn, size);
        jx = Arrays.copyOf(jx, size);
        jy = Arrays.copyOf(jy, size);
        jz = Arrays.copyOf(jz, size);
    }
}
