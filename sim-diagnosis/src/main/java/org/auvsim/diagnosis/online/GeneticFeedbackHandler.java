package org.auvsim.diagnosis.online;

import org.auvsim.core.description.Default;
import org.auvsim.core.description.Unit;
import org.auvsim.diagnosis.Method;

/**
 * Corrects and learns as {@link LearningFeedbackHandler} does, but by {@link Method#GENETIC}: a
 * population of models that compete side by side against what was measured (thesis, section 9.4).
 *
 * @param correctsBy what corrects the object
 * @param extendsWorld whether the world gets what was found; else it is only announced
 * @param after so much that is new must have been measured before it is diagnosed (again)
 * @param keep so many samples are kept; the oldest make room
 * @param seed of what is drawn by lot
 */
public record GeneticFeedbackHandler(
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
    public GeneticFeedbackHandler {
        var _ = new LearningPlan(extendsWorld, after, keep, seed, Method.GENETIC);
    }

    /** Filters, announces, and changes nothing. */
    public GeneticFeedbackHandler() {
        this(Corrector.KALMAN_FILTER, false, 30, 6000, 1);
    }

    @Override
    public Method method() {
        return Method.GENETIC;
    }
}
