package org.auvsim.core.step;

import org.auvsim.core.entity.Block;

/** A step that cannot be made; its message names the object and the time, and says what to do. */
public final class StepException extends RuntimeException {
    private static final long serialVersionUID = 1;

    /** With one clear sentence. */
    public StepException(String message) {
        super(message);
    }

    /** The forces on a body change so fast that no number of parts of a step is enough. */
    static StepException tooStiff(String name, double time, double step) {
        return new StepException(
                "the forces on '%s' are too stiff at %s s: %d parts of a step of %s s are not enough;"
                                .formatted(name, time, Block.MOST_SUB_STEPS, step)
                        + " lessen its damping or the time step");
    }

    /** With one clear sentence and what has led to it. */
    public StepException(String message, Throwable cause) {
        super(message, cause);
    }
}
