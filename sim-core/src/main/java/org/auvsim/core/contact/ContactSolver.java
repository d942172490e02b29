package org.auvsim.core.contact;

import static org.auvsim.core.contact.ContactBodies.SPEEDS;

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

    private final double absolute;
    private final double relative;
    private final int mostSweeps;
    private final boolean boundsEnergy;

    private final Rows rows = new Rows();
    private final Sweep sweep = new Sweep(rows);
    private final ConjugateSteps steps = new ConjugateSteps(rows);
    private final EnergyBound energyBound = new EnergyBound(rows);
    private final Solution solution = new Solution();
    private double[] start = new double[0];

    private ContactSolver(double absolute, double relative, int mostSweeps, boolean boundsEnergy) {
        this.absolute = absolute;
        this.relative = relative;
        this.mostSweeps = mostSweeps;
        this.boundsEnergy = boundsEnergy;
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
        int speeds = SPEEDS * bodies.count;
        if (start.length < speeds) {
            start = new double[2 * speeds];
        }
        System.arraycopy(bodies.v, 0, start, 0, speeds);
        solution.clear();
        rows.prepare(bodies, contacts);
        iterate(bodies.v, speeds);
        solution.energyGain = rows.work(rows.j, start, bodies.v);
        if (boundsEnergy && solution.energyGain > 0) {
            keepEnergy(bodies.v, speeds);
        }
        rows.report(bodies, contacts);
        return solution;
    }

    /** Sums the impulses that the contacts have as their guess, without solving anything. */
    public void sum(ContactBodies bodies, Contacts contacts) {
        rows.prepare(bodies, contacts);
        rows.report(bodies, contacts);
    }

    private void iterate(double[] v, int speeds) {
        double tolerance = absolute + relative * rows.fastest(start);
        rows.apply(rows.j, start, v, speeds);
        // The normals alone first: a stack needs hardly more, and no contact slides for want of
        // load.
        sweep.setSmooth(mostSweeps >= 4 && rows.isCold());
        steps.begin(speeds);
        int done;
        double error = sweepOnce(v, speeds);
        for (done = 2; done + 2 <= mostSweeps; done += 2) {
            if (sweep.isSmooth() && (error <= tolerance || done >= mostSweeps / 4)) {
                sweep.setSmooth(false);
                steps.begin(speeds);
            } else if (error <= tolerance) {
                break;
            } else {
                steps.extend(v, speeds, sweep.isSteady());
            }
            error = sweepOnce(v, speeds);
        }
        rows.keepInCone();
        // Summed once from the impulses, so that they and the speeds agree to rounding.
        rows.apply(rows.j, start, v, speeds);
        solution.sweeps += done;
        solution.error = Math.max(solution.error, error);
        solution.converged &= error <= tolerance;
    }

    /** There and back; gives the largest correction on the way back. */
    private double sweepOnce(double[] v, int speeds) {
        steps.mark(v, speeds);
        sweep.forward(v);
        return sweep.backward(v);
    }

    private void keepEnergy(double[] v, int speeds) {
        if (!energyBound.isSlight(start, v)) {
            energyBound.keepBouncing();
            iterate(v, speeds);
            solution.bounceKept = energyBound.blend(start, v, speeds);
        }
        solution.energyGain = energyBound.scale(start, v, speeds);
    }
}
