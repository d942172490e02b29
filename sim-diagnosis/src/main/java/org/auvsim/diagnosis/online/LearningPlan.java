package org.auvsim.diagnosis.online;

import org.auvsim.core.entity.Domain;
import org.auvsim.diagnosis.Method;

/**
 * When a learner diagnoses, and what it does with what it finds.
 *
 * @param extendsWorld whether the running world gets it; else it is only announced
 * @param after so much (s) that is new must have been measured before it is diagnosed (again)
 * @param keep so many samples are kept
 * @param seed of what is drawn by lot
 * @param method how causes are searched for
 */
record LearningPlan(boolean extendsWorld, double after, int keep, long seed, Method method) {
    private static final int LEAST_KEPT = 100;

    /**
     * A checked plan.
     *
     * @throws IllegalArgumentException if it would learn without pause, or keep too little
     */
    LearningPlan {
        Domain.above0("a learner", "new time before a diagnosis", after, "s");
        if (keep < LEAST_KEPT) {
            throw new IllegalArgumentException(
                    "a learner must keep %d samples or more, but is to keep %d"
                            .formatted(LEAST_KEPT, keep));
        }
    }
}
