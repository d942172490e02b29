package org.auvsim.server.feedback;

/**
 * Direct alteration: gives the object the position, orientation and velocities that were measured
 * (thesis, section 7.2). What was not measured stays: of a position alone, momenta and orientation.
 * No collision is looked for: the object may end inside another, which the notification then names.
 */
public record DirectPositionChangeFeedbackHandler() implements FeedbackProcessor {
    @Override
    public Phase phase() {
        return Phase.AFTER_STEP;
    }

    @Override
    public void process(Correction correction) {
        Target target = correction.target();
        target.position().ifPresent(correction.object()::setPosition);
        target.orientation().ifPresent(correction.object()::setOrientation);
        target.velocity().ifPresent(correction.object()::setVelocity);
        target.angularVelocity().ifPresent(correction.object()::setAngularVelocity);
    }
}
