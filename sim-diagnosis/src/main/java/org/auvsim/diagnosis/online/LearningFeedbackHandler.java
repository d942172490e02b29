package org.auvsim.diagnosis.online;

import org.auvsim.core.description.Default;
import org.auvsim.core.description.Unit;
import org.auvsim.diagnosis.Method;

/**
 * Corrects an object as another processor does, and learns meanwhile: what was measured and
 * commanded is diagnosed in the background, by {@link Method#SHOOTING}; what the model lacks is
 * announced and, if the scenario allows, added to the running world.
 *
 * @param correctsBy what corrects the object
 * @param extendsWorld whether the world gets what was found; else it is only announced
 * @param after so much that is new must have been measured before it is diagnosed (again)
 * @param keep so many samples are kept; the oldest make room
 * @param seed of what is drawn by lot
 */
public record LearningFeedbackHandler(
        @Default("kalman-filter") Corrector correctsBy,
        @Default("0") boolean extendsWorld,
        @Unit("s") @Default("30.0") double after,
        @Default("6000") int keep,
        @Default("1") long seed)
        implements LearningProcessor {
    /**
     * A checked processor.
     *
     * @throws IllegalArgumentException if it would learn without pause, or keep too little
     */
    public LearningFeedbackHandler {
        var _ = new LearningPlan(extendsWorld, after, keep, seed, Method.SHOOTING);
    }

    /** Filters, announces, and changes nothing. */
    public LearningFeedbackHandler() {
        this(Corrector.KALMAN_FILTER, false, 30, 6000, 1);
    }

    @Override
    public Method method() {
        return Method.SHOOTING;
    }
}
