package org.auvsim.server.feedback;

/** What vector adjustment does with the momentum of the object that it moves. */
public enum MomentumRule {
    /** The object ends the step with the momentum that the model gives it. */
    PROJECTED,
    /**
     * One constant force over the step, as the thesis has it. It leaves a velocity that is wrong by
     * 2 (Q - S_P)/dt, which rings from step to step.
     */
    AS_THESIS
}
