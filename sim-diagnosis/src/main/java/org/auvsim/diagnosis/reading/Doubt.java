package org.auvsim.diagnosis.reading;

import org.auvsim.diagnosis.result.Verdict;
import org.auvsim.diagnosis.run.Channel;

import java.util.Map;

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

    /** Errors (rad) of angles that might as well be drawn by lot are hardly smaller. */
    private static final double AT_RANDOM = 0.5;

    /**
     * Whether it is still open after a verdict.
     *
     * @param errors of the channels, in their units: angles whose errors are as large as angles can
     *     be are explained by nothing
     */
    public boolean isOpen(Verdict verdict, Map<Channel, Double> errors) {
        boolean isExplained =
                verdict != Verdict.UNEXPLAINED
                        && errors.getOrDefault(Channel.ORIENTATION, 0.0) < AT_RANDOM;
        return this == LASTING || (this == UNTIL_EXPLAINED && !isExplained);
    }

    /** The graver of two. */
    Doubt and(Doubt other) {
        return this == LASTING || other == NONE ? this : other;
    }
}
