package org.auvsim.auvsml.document;

/** What vector adjustment does with the velocity of the object that it moves. */
public enum MomentumRule {
    /** The object ends the step with the velocity that was measured, else with the model's. */
    PROJECTED("projected"),
    /**
     * One constant force over the step, as the thesis has it; where a position was measured, it
     * leaves a velocity that is wrong by 2 (Q - S_P)/dt, which rings from step to step.
     */
    AS_THESIS("as-thesis");

    private final String text;

    MomentumRule(String text) {
        this.text = text;
    }

    /** As AUVSML has it. */
    @Override
    public String toString() {
        return text;
    }
}
