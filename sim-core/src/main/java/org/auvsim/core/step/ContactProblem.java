package org.auvsim.core.step;

import org.auvsim.core.contact.ContactBodies;
import org.auvsim.core.contact.Contacts;
import org.auvsim.core.entity.BodyState;
import org.auvsim.core.volume.Manifold;
import org.auvsim.core.volume.Pose;

import java.util.Arrays;

/** The bodies and contact points of one island, made ready for a solver; filled again and again. */
final class ContactProblem {
    private static final int NONE = -1;

    /** What the solver sees. */
    final ContactBodies bodies = new ContactBodies();

    final Contacts contacts = new Contacts();

    private final BodyState state;
    private final BodyTraits traits;
    private final Trajectories trajectories;
    private final int[] local;
    private int[] slots = new int[16];
    private double[] gap = new double[16];
    private final double[] speeds = new double[6];
    private final int[] one = new int[1];
    private final Pose pose = new Pose();
    private final Corners corners = new Corners();

    ContactProblem(BodyState state, BodyTraits traits, Trajectories trajectories) {
        this.state = state;
        this.traits = traits;
        this.trajectories = trajectories;
        local = new int[state.count()];
        Arrays.fill(local, NONE);
    }

    void clear() {
        for (int k = 0; k < bodies.count; k++) {
            local[slots[k]] = NONE;
        }
        bodies.clear();
        contacts.clear();
    }

    /** The number of a body, which is added with its present velocities if it is new. */
    int body(int slot) {
        if (local[slot] == NONE) {
            add(slot);
        }
        return local[slot];
    }

    private void add(int slot) {
        state.pose(slot, pose);
        place(slot, pose);
        if (!traits.isFixed[slot]) {
            one[0] = slot;
            trajectories.velocitiesNow(one, 1, speeds);
            setVelocity(local[slot], speeds, 0);
        }
    }

    /** Adds a body in a pose; it stands still until it is given a velocity. */
    void place(int slot, Pose at) {
        int k = bodies.add(at.x, at.y, at.z);
        local[slot] = k;
        if (slots.length == k) {
            slots = Arrays.copyOf(slots, 2 * k);
        }
        slots[k] = slot;
        if (traits.isFixed[slot]) {
            return;
        }
        if (traits.isPlainBall(slot)) {
            int row = ContactBodies.RESPONSES * k;
            double inverseMass = state.inverseMass()[slot];
            bodies.k[row] = inverseMass;
            bodies.k[row + 7] = inverseMass;
            bodies.k[row + 14] = inverseMass;
        } else {
            state.inverseInertia6(
                    slot, at.qw, at.qx, at.qy, at.qz, bodies.k, ContactBodies.RESPONSES * k);
        }
    }

    void setVelocity(int body, double[] from, int at) {
        System.arraycopy(from, at, bodies.v, ContactBodies.SPEEDS * body, ContactBodies.SPEEDS);
    }

    /** Gives the first so many bodies these velocities, six numbers a body. */
    void setVelocities(int count, double[] from) {
        System.arraycopy(from, 0, bodies.v, 0, ContactBodies.SPEEDS * count);
    }

    /**
     * Gives a body the velocity that it would have without a force.
     *
     * @param with the velocities with it, six numbers a body
     * @param forces and torques on the bodies (N, N m), six numbers a body
     * @param h how long (s) they act
     */
    void setFree(int body, double[] with, double[] forces, double h) {
        int at = ContactBodies.SPEEDS * body;
        int row = ContactBodies.RESPONSES * body;
        for (int r = 0; r < ContactBodies.SPEEDS; r++, row += ContactBodies.SPEEDS) {
            double change = 0;
            for (int c = 0; c < ContactBodies.SPEEDS; c++) {
                change += bodies.k[row + c] * forces[at + c];
            }
            bodies.v[at + r] = with[at + r] - h * change;
        }
    }

    /** Adds the points where two bodies touch; a and b are slots. */
    void add(int a, int b, Manifold points) {
        int first = body(a);
        int second = body(b);
        double friction = Math.sqrt(traits.friction[a] * traits.friction[b]);
        int chosen = corners.choose(points);
        boolean isCentral = traits.arePlainBalls(a, b);
        for (int k = 0; k < chosen; k++) {
            add(first, second, points, corners.chosen()[k], friction, isCentral);
        }
        for (int k = 0; chosen < 0 && k < points.count; k++) {
            add(first, second, points, k, friction, isCentral);
        }
    }

    private void add(
            int first, int second, Manifold points, int k, double friction, boolean isCentral) {
        int c =
                contacts.add(
                        first,
                        second,
                        points.x[k],
                        points.y[k],
                        points.z[k],
                        points.nx[k],
                        points.ny[k],
                        points.nz[k]);
        contacts.friction[c] = friction;
        contacts.isCentral[c] = isCentral;
        if (c >= gap.length) {
            gap = Arrays.copyOf(gap, 2 * gap.length);
        }
        gap[c] = points.gap[k];
    }

    /** The gap (m) at a contact; negative where the bodies overlap. */
    double gap(int contact) {
        return gap[contact];
    }

    int slot(int body) {
        return slots[body];
    }

    /**
     * How fast the bodies approach at the contacts from {@code from} on, where it is fastest (m/s).
     */
    double fastestApproach(int from) {
        double fastest = Double.NEGATIVE_INFINITY;
        for (int c = from; c < contacts.count; c++) {
            fastest = Math.max(fastest, -contacts.separationSpeed(c, bodies));
        }
        return fastest;
    }

    /** Gives the bodies the momenta that the solver's impulses add. */
    void applyImpulses() {
        for (int k = 0; k < bodies.count; k++) {
            state.addMomenta(slots[k], bodies.impulse, ContactBodies.SPEEDS * k);
        }
    }
}
