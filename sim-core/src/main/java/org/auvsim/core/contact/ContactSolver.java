package org.auvsim.core.contact;

/**
 * Finds the impulses at the contacts of an island, all together: along each normal the bodies part
 * at the contact's target speed or faster, they are only ever pushed apart, and what pushes parts
 * them at just the target; across it, friction stays within Coulomb's isotropic cone and, where it
 * is on the cone's edge, points straight against the slip.
 *
 * <pre>
 * v' = v + K sum (j, r x j)    v_n' &gt;= target, j_n &gt;= 0, j_n (v_n' - target) = 0    |j_t| &lt;= mu j_n
 * </pre>
 *
 * <p>Slip is what goes beyond {@link Contacts#slipX}. Where friction does not come to an end within
 * the sweeps that are allowed, contacts that rest get the normal impulses that keep the bodies
 * apart all the same; bodies may slip a little more then.
 *
 * <p>Symmetric projected Gauss-Seidel with conjugate steps, in the order of the contacts: the same
 * input gives the same bits. A symmetric input gives a symmetric answer to within the accuracy
 * asked for, not to the bit. Where the impulses are not determined (four points under a rigid box)
 * the speeds still are, and the impulses are those nearest to the guess that the sweeps come to.
 *
 * <p>Owns its scratch: one for each thread. It allocates only for islands larger than any before.
 */
public final class ContactSolver {
    /** As near as sweeps get in double precision on chains of some ten bodies. */
    private static final double IMPACT_ACCURACY = 1e-11;

    private static final int IMPACT_SWEEPS = 400;

    /** So often at most contacts are visited in a solution, but for a few sweeps. */
    private static final int MOST_VISITS = 40_000;

    private static final int FEW_SWEEPS = 60;

    private final double absolute;
    private final double relative;
    private final int mostSweeps;
    private final boolean boundsEnergy;
    private final Relaxation spatial;
    private final Relaxation central;
    private final Solution solution = new Solution();

    private ContactSolver(double absolute, double relative, int mostSweeps, boolean boundsEnergy) {
        this.absolute = absolute;
        this.relative = relative;
        this.mostSweeps = mostSweeps;
        this.boundsEnergy = boundsEnergy;
        spatial = new Relaxation(new SpatialRows(), !boundsEnergy);
        central = new Relaxation(new CentralRows(), !boundsEnergy);
    }

    /**
     * A solver for impacts at an instant, to 1e-11 of the fastest approach. Kinetic energy never
     * grows: should the targets ask for more than there is, all of them are lowered by one factor
     * to just what keeps it, see {@link Solution#bounceKept()}.
     */
    public static ContactSolver forImpacts() {
        return new ContactSolver(0, IMPACT_ACCURACY, IMPACT_SWEEPS, /* boundsEnergy= */ true);
    }

    /**
     * A solver for contacts that rest. The targets may push: energy is reported, not bounded.
     *
     * @param tolerance the largest correction (m/s) that the last sweep may have made
     * @param mostSweeps bound on the work, at least 2
     */
    public static ContactSolver forResting(double tolerance, int mostSweeps) {
        if (!(tolerance >= 0) || mostSweeps < 2) {
            throw new IllegalArgumentException(
                    "A contact solver needs a tolerance of 0 or more and at least 2 sweeps, not "
                            + tolerance
                            + " and "
                            + mostSweeps
                            + ".");
        }
        return new ContactSolver(tolerance, 0, mostSweeps, /* boundsEnergy= */ false);
    }

    /**
     * Sets the bodies' speeds to those after the contacts, the contacts' impulses (from the ones
     * there as a first guess) and the bodies' sums of impulses.
     *
     * @return how well it went; valid until the next call
     */
    public Solution solve(ContactBodies bodies, Contacts contacts) {
        Relaxation relaxation = relaxation(contacts);
        relaxation.begin(bodies, contacts);
        solution.clear();
        double tolerance = absolute + relative * relaxation.fastest();
        int sweeps = sweeps(contacts.count);
        relaxation.iterate(tolerance, sweeps, solution);
        solution.energyGain = relaxation.energyGain();
        if (boundsEnergy && solution.energyGain > 0) {
            relaxation.keepEnergy(tolerance, sweeps, solution);
        }
        relaxation.end(bodies, contacts);
        return solution;
    }

    /** Sums the impulses that the contacts have as their guess, without solving anything. */
    public void sum(ContactBodies bodies, Contacts contacts) {
        relaxation(contacts).sum(bodies, contacts);
    }

    /** Many contacts that rest get fewer sweeps each, so that no island stops the world. */
    private int sweeps(int contacts) {
        if (boundsEnergy || contacts == 0) {
            return mostSweeps;
        }
        int affordable = MOST_VISITS / contacts;
        return Math.max(Math.min(FEW_SWEEPS, mostSweeps), Math.min(affordable, mostSweeps));
    }

    private Relaxation relaxation(Contacts contacts) {
        return contacts.areCentral() ? central : spatial;
    }
}
