package org.auvsim.diagnosis.reading;

import org.auvsim.diagnosis.result.Verdict;

/** Whether the numbers of runs may not be what they are taken for; notices say why. */
public enum Doubt {
    /** They look like what they are taken for. */
    NONE,

    /**
     * What a model predicts to the noise is what it was taken for: angles that go round several
     * times are then not in degrees, axes that few of the runs speak for not those.
     */
    UNTIL_EXPLAINED,

    /**
     * Units, axes or commands look as if they were others, and might pass for what explains the
     * runs.
     */
    LASTING;

    /** Whether it is still open after a verdict. */
    public boolean isOpen(Verdict verdict) {
        return this == LASTING || (this == UNTIL_EXPLAINED && verdict == Verdict.UNEXPLAINED);
    }

    /** The graver of two. */
    Doubt and(Doubt other) {
        return this == LASTING || other == NONE ? this : other;
    }
}
