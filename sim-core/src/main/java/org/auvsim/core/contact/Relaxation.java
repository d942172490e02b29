package org.auvsim.core.contact;

/** Sweeps over the contacts of one island until little changes, and keeps the energy bound. */
final class Relaxation {
    private final Rows rows;
    private final Sweep sweep;
    private final ConjugateSteps steps;
    private final EnergyBound energyBound;
    private double[] start = new double[0];
    private double[] v = new double[0];
    private int speeds;
    private final boolean keepsApart;

    /**
     * @param keepsApart whether targets matter more than Coulomb's cone where both cannot be met
     *     within the sweeps that are allowed
     */
    Relaxation(Rows rows, boolean keepsApart) {
        this.rows = rows;
        this.keepsApart = keepsApart;
        sweep = new Sweep(rows);
        steps = new ConjugateSteps(rows);
        energyBound = new EnergyBound(rows);
    }

    void begin(ContactBodies bodies, Contacts contacts) {
        speeds = rows.speedsABody * bodies.count;
        if (start.length < speeds) {
            start = new double[2 * speeds];
            v = new double[2 * speeds];
        }
        rows.load(bodies, start);
        rows.prepare(bodies, contacts);
    }

    /** The fastest wanted change of speed along a normal (m/s). */
    double fastest() {
        return rows.fastest(start);
    }

    void iterate(double tolerance, int mostSweeps, Solution solution) {
        rows.apply(rows.j, start, v, speeds);
        // The normals alone first: a stack needs hardly more, and no contact slides for want of
        // load.
        sweep.setSmooth(mostSweeps >= 4 && rows.isCold());
        steps.begin(speeds);
        int done;
        double error = sweepOnce();
        for (done = 2; done + 2 <= mostSweeps; done += 2) {
            if (sweep.isSmooth() && (error <= tolerance || done >= mostSweeps / 4)) {
                sweep.setSmooth(false);
                steps.begin(speeds);
            } else if (error <= tolerance) {
                break;
            } else {
                steps.extend(v, speeds, sweep.isSteady());
            }
            error = sweepOnce();
        }
        rows.keepInCone();
        if (error > tolerance && keepsApart) {
            keepApart(tolerance, mostSweeps);
        }
        // Summed once from the impulses, so that they and the speeds agree to rounding.
        rows.apply(rows.j, start, v, speeds);
        solution.sweeps += done;
        solution.error = Math.max(solution.error, error);
        solution.converged &= error <= tolerance;
    }

    /**
     * Where friction did not come to an end, it is left as it is, and the normals alone are put
     * right, which is quick: bodies may slip a little more than they should, but must not meet.
     */
    private void keepApart(double tolerance, int mostSweeps) {
        rows.apply(rows.j, start, v, speeds);
        sweep.setSmooth(true);
        steps.begin(speeds);
        double error = sweepOnce();
        for (int done = 2; error > tolerance && done + 2 <= mostSweeps; done += 2) {
            steps.extend(v, speeds, sweep.isSteady());
            error = sweepOnce();
        }
    }

    /** There and back; gives the largest correction on the way back. */
    private double sweepOnce() {
        steps.mark(v, speeds);
        sweep.forward(v);
        return sweep.backward(v);
    }

    /** Kinetic energy (J) that the impulses give. */
    double energyGain() {
        return rows.work(rows.j, start, v);
    }

    /** Lowers what the contacts ask for until they give no energy. */
    void keepEnergy(double tolerance, int mostSweeps, Solution solution) {
        if (!energyBound.isSlight(start, v)) {
            energyBound.keepBouncing();
            iterate(tolerance, mostSweeps, solution);
            solution.bounceKept = energyBound.blend(start, v, speeds);
        }
        solution.energyGain = energyBound.scale(start, v, speeds);
    }

    void end(ContactBodies bodies, Contacts contacts) {
        rows.store(v, bodies);
        rows.report(bodies, contacts);
    }

    void sum(ContactBodies bodies, Contacts contacts) {
        rows.prepare(bodies, contacts);
        rows.report(bodies, contacts);
    }
}
