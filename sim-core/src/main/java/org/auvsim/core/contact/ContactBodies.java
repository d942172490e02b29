package org.auvsim.core.contact;

import java.util.Arrays;

/**
 * The bodies of one island of contacts, numbered from 0 in the order in which they were added. Made
 * to be cleared and filled again: it allocates only when it has never held so many.
 */
public final class ContactBodies {
    /** Numbers a body in {@link #v} and {@link #impulse}. */
    public static final int SPEEDS = 6;

    /** Numbers a body in {@link #k}. */
    public static final int RESPONSES = SPEEDS * SPEEDS;

    /** How many there are. */
    public int count;

    /** Velocity of the origin (m/s), then angular velocity (rad/s), both in the world frame. */
    public double[] v = new double[2 * SPEEDS];

    /**
     * What an impulse does: the inverse of the 6x6 inertia about the body's origin, added mass
     * included, in world axes; row by row, linear before angular. Symmetric; zeros for what cannot
     * move.
     */
    public double[] k = new double[2 * RESPONSES];

    /** The origin (m, world). */
    public double[] x = new double[2 * 3];

    /**
     * The solver's answer: what momentum (N s) and angular momentum about the origin changed by.
     */
    public double[] impulse = new double[2 * SPEEDS];

    /** Forgets all bodies. */
    public void clear() {
        count = 0;
    }

    /**
     * Adds a body that stands still and cannot move; set its {@link #v} and {@link #k} to change
     * that.
     *
     * @return its index
     */
    public int add(double originX, double originY, double originZ) {
        if (SPEEDS * count == v.length) {
            grow();
        }
        int body = count++;
        Arrays.fill(v, SPEEDS * body, SPEEDS * (body + 1), 0);
        Arrays.fill(k, RESPONSES * body, RESPONSES * (body + 1), 0);
        Arrays.fill(impulse, SPEEDS * body, SPEEDS * (body + 1), 0);
        x[3 * body] = originX;
        x[3 * body + 1] = originY;
        x[3 * body + 2] = originZ;
        return body;
    }

    private void grow() {
        v = Arrays.copyOf(v, 2 * v.length);
        k = Arrays.copyOf(k, 2 * k.length);
        x = Arrays.copyOf(x, 2 * x.length);
        impulse = Arrays.copyOf(impulse, 2 * impulse.length);
    }
}
