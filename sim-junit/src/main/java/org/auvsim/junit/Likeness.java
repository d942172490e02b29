package org.auvsim.junit;

import static org.auvsim.junit.Figures.requireLimit;
import static org.auvsim.junit.Figures.text;

import java.util.Optional;

/** How a body's replay differs from its recording, at the times that the recording has. */
final class Likeness {
    private final Trajectory body;
    private final double tolerance;
    private final double angle;

    /** Allows for a difference in position (m) and one in orientation (rad). */
    Likeness(Trajectory body, double tolerance, double angle) {
        requireLimit("a tolerance", tolerance, "m");
        requireLimit("an angle", angle, "rad");
        this.body = body;
        this.tolerance = tolerance;
        this.angle = angle;
    }

    /**
     * The first difference that is not allowed.
     *
     * @throws IllegalStateException if there is nothing to compare with
     */
    Optional<Finding> difference() {
        if (!body.replay().isOfRecording()) {
            throw new IllegalStateException(
                    "a scenario has no movements to match; record it with 'auvsim serve --record'"
                            + " and name the recording in @ReplayScenario");
        }
        if (body.recorded().isEmpty()) {
            return Optional.of(
                    new Finding(
                            "is not in the recording, but here",
                            body.first(),
                            "it is at " + text(body.first().position()),
                            "expected no such body"));
        }
        return body.recorded().stream().flatMap(pose -> at(pose).stream()).findFirst();
    }

    private Optional<Finding> at(Pose pose) {
        if (!body.isThereAt(pose.time())) {
            return Optional.of(
                    new Finding(
                            "ends before its recording",
                            body.last(),
                            "it is not in the world at %s s".formatted(text(pose.time())),
                            "expected at " + text(pose.position())));
        }
        Sample sample = body.at(pose.time());
        double distance = sample.position().distance(pose.position());
        if (distance > tolerance) {
            return Optional.of(elsewhere(sample, pose, distance));
        }
        double turn = pose.angle(sample.orientation());
        return turn > angle ? Optional.of(turned(sample, turn)) : Optional.empty();
    }

    private Finding elsewhere(Sample sample, Pose pose, double distance) {
        return new Finding(
                "differs from the recording",
                sample,
                "%s, %s m from the recorded %s"
                        .formatted(text(sample.position()), text(distance), text(pose.position())),
                "allowed %s m%s".formatted(text(tolerance), worst()));
    }

    private Finding turned(Sample sample, double turn) {
        return new Finding(
                "differs from the recording",
                sample,
                "it is turned by %s rad".formatted(text(turn)),
                "allowed %s rad".formatted(text(angle)));
    }

    private String worst() {
        Approach worst = new Approach(0, 0);
        for (Pose pose : body.recorded()) {
            if (body.isThereAt(pose.time())) {
                double distance = body.at(pose.time()).position().distance(pose.position());
                worst = distance > worst.distance() ? new Approach(pose.time(), distance) : worst;
            }
        }
        return "; most, %s m, at %s s".formatted(text(worst.distance()), text(worst.time()));
    }
}
