package org.auvsim.server.feedback;

import org.auvsim.auvsml.message.feedback.FeedbackMessage;
import org.auvsim.core.entity.WorldObject;
import org.auvsim.core.entity.Wrench;

import java.util.Optional;

/** What a {@link FeedbackProcessor} may see of the step and do to the object that it corrects. */
public interface Correction {
    /** What the client sent. */
    FeedbackMessage message();

    /** The object: before the step or after it, as the processor's phase has it. */
    WorldObject object();

    /** The world's time (s) of {@link #target()}. */
    double time();

    /**
     * How the object ought to be at the end of the step. A measurement from within the step has the
     * model's own motion from there on added.
     */
    Target target();

    /** How the step would leave the object without this correction. */
    RigidMotion projected();

    /** How long the step is (s). */
    double duration();

    /**
     * How the step would leave the object if these forces and torques, beside all others, acted on
     * it in the first and the second half of the step; all tried out on a copy.
     *
     * @param firstHalf the force in the world's, the torque in the body's axes
     * @param secondHalf likewise
     * @return empty if the step cannot be made with them
     */
    Optional<RigidMotion> tried(Wrench firstHalf, Wrench secondHalf);

    /** Lets these act during the step, and no longer; for {@code BEFORE_STEP}. */
    void push(Wrench firstHalf, Wrench secondHalf);

    /** How the object moved when the step began. */
    RigidMotion start();

    /**
     * How the step would leave the object if it had begun so; tried out on a copy. After the step
     * only for a processor that {@link FeedbackProcessor#looksBack()}.
     *
     * @return empty if the step cannot be made from there
     */
    Optional<RigidMotion> steppedFrom(RigidMotion start);

    /** What this processor has remembered of this object. */
    <M> Optional<M> memory(Class<M> type);

    /** Remembers an immutable value until the next correction of this object by this processor. */
    void remember(Object value);

    /** Says that the processor could not reach what it aimed at. */
    void fellShort();
}
