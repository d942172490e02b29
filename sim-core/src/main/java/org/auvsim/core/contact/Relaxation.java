package org.auvsim.core.contact;

/** Sweeps over the contacts of one island until little changes, and keeps the energy bound. */
final class Relaxation {
    private final Rows rows;
    private final Sweep sweep;
    private final ConjugateSteps steps;
    private final EnergyBound energyBound;
    private final boolean keepsApart;

    /** The bodies' speeds before and, as far as it has come, after the impulses. */
    private double[] start = new double[0];

    private double[] v = new double[0];
    private int speeds;

    /** How often the contacts have been gone through since the impulses were last applied. */
    private int sweeps;

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

    /** Takes the contacts and what is guessed of their impulses. */
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

    /** Makes the impulses better until a sweep corrects no more than the tolerance (m/s). */
    void iterate(double tolerance, int mostSweeps, Solution solution) {
        applyImpulses();
        if (mostSweeps >= 4 && rows.isCold()) {
            // The normals alone first: a stack needs hardly more, and no contact slides for want
            // of load.
            sweepUntil(/* smooth= */ true, tolerance, mostSweeps / 4 + 1);
        }
        double error = sweepUntil(/* smooth= */ false, tolerance, mostSweeps);
        solution.error = Math.max(solution.error, error);
        solution.converged &= error <= tolerance;
        rows.keepInCone();
        if (error > tolerance && keepsApart) {
            // Where friction did not come to an end, it is left as it is, and the normals alone are
            // put right, which is quick: bodies may slip a little more than they should, but must
            // not meet.
            applyImpulses();
            sweepUntil(/* smooth= */ true, tolerance, mostSweeps);
        }
        // Summed once from the impulses, so that they and the speeds agree to rounding.
        applyImpulses();
    }

    private void applyImpulses() {
        rows.apply(rows.j, start, v, speeds);
        sweeps = 0;
    }

    /** Sweeps, there and back at least, with or without friction; the last error (m/s). */
    private double sweepUntil(boolean smooth, double tolerance, int mostSweeps) {
        sweep.setSmooth(smooth);
        steps.begin(speeds);
        double error = sweepOnce();
        while (error > tolerance && sweeps + 2 <= mostSweeps) {
            steps.extend(v, speeds, sweep.isSteady());
            error = sweepOnce();
        }
        return error;
    }

    /** There and back; gives the largest correction on the way back. */
    private double sweepOnce() {
        sweeps += 2;
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

    /** Hands speeds and impulses over. */
    void end(ContactBodies bodies, Contacts contacts) {
        rows.store(v, bodies);
        rows.report(bodies, contacts);
    }

    /** Hands over the impulses that the contacts have as their guess, and changes no speed. */
    void sum(ContactBodies bodies, Contacts contacts) {
        rows.prepare(bodies, contacts);
        rows.report(bodies, contacts);
    }
}
