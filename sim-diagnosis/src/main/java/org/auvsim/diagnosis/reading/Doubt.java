package org.auvsim.diagnosis.reading;

import org.auvsim.diagnosis.result.Verdict;

/** Whether the numbers of runs may not be what they are taken for; notices say why. */
public enum Doubt {
    /** They look like what they are taken for. */
    NONE,

    /** Angles go round several times, or very fast: they may be in degrees. */
    OF_TURNS,

    /** Units, axes or commands look as if they were others. */
    OF_DATA;

    /**
     * Whether it is still open after a verdict. What a model predicts to the noise was no angle in
     * degrees that was read in radians; positions in another unit may pass for another cause.
     */
    public boolean isOpen(Verdict verdict) {
        return this == OF_DATA || (this == OF_TURNS && verdict == Verdict.UNEXPLAINED);
    }

    /** The graver of two. */
    Doubt and(Doubt other) {
        return this == OF_DATA || other == NONE ? this : other;
    }
}
