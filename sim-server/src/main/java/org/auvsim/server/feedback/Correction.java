package org.auvsim.server.feedback;

import org.auvsim.core.entity.MovementState;
import org.auvsim.core.entity.WorldObject;
import org.auvsim.core.math.Vec3;

import java.util.Optional;

/** What a {@link FeedbackProcessor} may see of the step and do to the object that it corrects. */
public interface Correction {
    /** The object: before the step or after it, as the processor's phase has it. */
    WorldObject object();

    /** Where it ought to be (m, world): at the end of the step, or now after it. */
    Vec3 target();

    /** How the step would leave the object without this correction. */
    MovementState projected();

    /** How long the step is (s). */
    double duration();

    /**
     * How the step would leave the object if these forces (N, world), beside all others, acted at
     * its origin in the first and the second half of the step; all tried out on a copy.
     *
     * @return empty if the step cannot be made with them
     */
    Optional<MovementState> tried(Vec3 firstHalf, Vec3 secondHalf);

    /** Lets these forces act during the step, and no longer; for {@code BEFORE_STEP}. */
    void push(Vec3 firstHalf, Vec3 secondHalf);
}
