package org.auvsim.server.feedback;

import org.auvsim.auvsml.message.feedback.DifferentStateFeedbackMessage;

import java.util.Optional;

/** Messages that tests send. */
final class Messages {
    private Messages() {}

    /** All of a motion, of object 1, in the world's axes. */
    static DifferentStateFeedbackMessage state(double time, String handler, RigidMotion motion) {
        return new DifferentStateFeedbackMessage(
                1,
                time,
                handler,
                Optional.empty(),
                Optional.of(motion.position()),
                Optional.of(motion.orientation()),
                Optional.of(motion.velocity()),
                Optional.of(motion.angularVelocity()),
                Optional.empty());
    }
}
