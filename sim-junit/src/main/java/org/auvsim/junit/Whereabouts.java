package org.auvsim.junit;

import static org.auvsim.junit.Figures.requireLimit;
import static org.auvsim.junit.Figures.text;

import org.auvsim.core.math.Vec3;

import java.util.List;
import java.util.Optional;

/** What is wrong with where a body is, or how fast. */
final class Whereabouts {
    private final Trajectory body;

    Whereabouts(Trajectory body) {
        this.body = body;
    }

    Optional<Finding> outside(Region region, List<Trajectory> beside) {
        return body.samples().stream()
                .flatMap(
                        sample ->
                                region.breach(sample.time(), sample.position()).stream()
                                        .map(breach -> finding(breach, sample, beside)))
                .findFirst();
    }

    private static Finding finding(Region.Breach breach, Sample at, List<Trajectory> beside) {
        return new Finding(
                breach.verb(), at, breach.actual(), "allowed " + breach.allowed(), beside);
    }

    Optional<Finding> tooNear(Trajectory other, double distance) {
        requireLimit("a distance", distance, "m");
        return body.nearestTo(other)
                .filter(nearest -> nearest.distance() < distance)
                .map(
                        nearest ->
                                new Finding(
                                        "is too near to '%s'".formatted(other.name()),
                                        body.at(nearest.time()),
                                        text(nearest.distance()) + " m from origin to origin",
                                        "allowed %s m or more".formatted(text(distance)),
                                        List.of(other)));
    }

    Optional<Finding> missed(Vec3 point, double tolerance) {
        requireLimit("a tolerance", tolerance, "m");
        Approach nearest = body.nearestTo(point);
        if (nearest.distance() <= tolerance) {
            return Optional.empty();
        }
        return Optional.of(
                new Finding(
                        "misses %s and is nearest".formatted(text(point)),
                        body.at(nearest.time()),
                        text(nearest.distance()) + " m away",
                        "allowed %s m".formatted(text(tolerance))));
    }

    Optional<Finding> endsElsewhere(Vec3 point, double tolerance) {
        requireLimit("a tolerance", tolerance, "m");
        Sample last = body.last();
        double distance = last.position().distance(point);
        if (distance <= tolerance) {
            return Optional.empty();
        }
        return Optional.of(
                new Finding(
                        "ends in the wrong place",
                        last,
                        "%s, %s m from %s"
                                .formatted(text(last.position()), text(distance), text(point)),
                        "allowed %s m".formatted(text(tolerance))));
    }

    Optional<Finding> tooFast(double speed) {
        requireLimit("a speed", speed, "m/s");
        return body.samples().stream()
                .filter(sample -> sample.velocity().norm() > speed)
                .findFirst()
                .map(
                        sample ->
                                new Finding(
                                        "is too fast",
                                        sample,
                                        text(sample.velocity().norm()) + " m/s",
                                        "allowed %s m/s".formatted(text(speed))));
    }
}
