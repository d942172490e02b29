package org.auvsim.viz.source;

import org.auvsim.auvsml.message.feedback.FeedbackMessage;
import org.auvsim.auvsml.message.feedback.Measurement;
import org.auvsim.core.math.Vec3;

import java.util.Optional;

/** Where a robot measured that it was, in the world's axes. */
final class MeasuredPlace {
    private MeasuredPlace() {}

    /**
     * The place (m, world), if one was measured.
     *
     * @param track of the object in the simulator, as it was known when the feedback came: one in
     *     the object's own axes is a way from there
     */
    static Optional<Vec3> of(FeedbackMessage feedback, Track track) {
        Measurement measured = feedback.measurement();
        double time = feedback.timestamp();
        return switch (measured.frame()) {
            case WORLD -> measured.position();
            case NED -> measured.position().map(p -> new Vec3(p.y(), p.x(), -p.z()));
            case BODY ->
                    measured.position()
                            .filter(_ -> track.times().count() > 0)
                            .map(p -> track.turnAt(time).rotate(p).plus(track.placeAt(time)));
        };
    }
}
