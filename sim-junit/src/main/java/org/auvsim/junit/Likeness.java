package org.auvsim.junit;

import static org.auvsim.junit.Figures.requireLimit;
import static org.auvsim.junit.Figures.text;

import java.util.List;
import java.util.Optional;

/** How a body's replay differs from its recording, at the times that the recording has. */
final class Likeness {
    /** Steps of equal bodies are made at equal times, but for rounding (s). */
    private static final double MOMENT = 1e-6;

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
        return body.recorded().map(this::difference).orElseGet(() -> Optional.of(surplus()));
    }

    private Optional<Finding> difference(List<Pose> recorded) {
        return recorded.stream()
                .flatMap(pose -> at(pose, recorded).stream())
                .findFirst()
                .or(() -> lasting(recorded));
    }

    private Finding surplus() {
        return new Finding(
                "is here, and not in the recording,",
                body.first(),
                "at " + text(body.first().position()),
                "expected no such body");
    }

    /** Of a body that left the world when it was recorded, and does not leave it now. */
    private Optional<Finding> lasting(List<Pose> recorded) {
        if (recorded.isEmpty() || !(body.last().time() > recorded.getLast().time() + MOMENT)) {
            return Optional.empty();
        }
        return Optional.of(
                new Finding(
                        "is there longer than in the recording, still",
                        body.last(),
                        "at " + text(body.last().position()),
                        "expected to leave at %s s".formatted(text(recorded.getLast().time()))));
    }

    private Optional<Finding> at(Pose pose, List<Pose> recorded) {
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
            return Optional.of(elsewhere(sample, pose, worst(recorded)));
        }
        double turn = pose.angle(sample.orientation());
        return turn > angle ? Optional.of(turned(sample, turn)) : Optional.empty();
    }

    private Finding elsewhere(Sample sample, Pose pose, Approach worst) {
        double distance = sample.position().distance(pose.position());
        return new Finding(
                "differs from the recording",
                sample,
                "%s, %s m from the recorded %s"
                        .formatted(text(sample.position()), text(distance), text(pose.position())),
                "allowed %s m; most, %s m, at %s s"
                        .formatted(text(tolerance), text(worst.distance()), text(worst.time())));
    }

    private Finding turned(Sample sample, double turn) {
        return new Finding(
                "differs from the recording",
                sample,
                "it is turned by %s rad".formatted(text(turn)),
                "allowed %s rad".formatted(text(angle)));
    }

    private Approach worst(List<Pose> recorded) {
        Approach worst = new Approach(0, 0);
        for (Pose pose : recorded) {
            if (body.isThereAt(pose.time())) {
                double distance = body.at(pose.time()).position().distance(pose.position());
                worst = distance > worst.distance() ? new Approach(pose.time(), distance) : worst;
            }
        }
        return worst;
    }
}
