package org.auvsim.core.step;

/** Leaves the step as it is wanted, for worlds where overlap is allowed (thesis, section 5.1.4). */
public record NoRestricter() implements TimeStepRestricter {
    @Override
    public double restrict(Motion motion, double wanted) {
        return wanted;
    }
}
