package org.auvsim.core.contact;

/**
 * How well a {@link ContactSolver} did. It belongs to the solver and is overwritten by the next.
 */
public final class Solution {
    double error;
    boolean converged;
    double energyGain;
    double bounceKept;

    Solution() {}

    void clear() {
        error = 0;
        converged = true;
        energyGain = 0;
        bounceKept = 1;
    }

    /** The largest correction (m/s) that the last sweep made at a contact. */
    public double error() {
        return error;
    }

    /** Whether the error came down to what was asked within the sweeps that are allowed. */
    public boolean converged() {
        return converged;
    }

    /** Kinetic energy (J) that the contacts added: 0 or less if the solver is one for impacts. */
    public double energyGain() {
        return energyGain;
    }

    /**
     * The share of the target speeds that was kept: 1 unless together they would have added energy,
     * as restitution at several contacts or with friction may.
     */
    public double bounceKept() {
        return bounceKept;
    }
}
