package org.auvsim.core.step;

import org.auvsim.core.entity.Block;
import org.auvsim.core.entity.RigidBody;

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

    /** Two collide without end in a step. */
    static StepException endless(String one, String other, long events, double time) {
        return new StepException(
                "'%s' and '%s' collide without end at %s s: %d events in one step; check their"
                                .formatted(one, other, time, events)
                        + " forces and restitution, or shorten the time step");
    }

    /** The motion of a body is not finite at the end of a step, by something that acts on it. */
    static StepException runaway(RigidBody body, double time, double step, String culprit) {
        return new StepException(
                "the motion of '%s' (id %d) gets out of all bounds between %s s and %s s by %s;"
                                .formatted(body.name(), body.id(), time, time + step, culprit)
                        + " lessen its forces or the time step");
    }

    /** With one clear sentence and what has led to it. */
    public StepException(String message, Throwable cause) {
        super(message, cause);
    }
}
