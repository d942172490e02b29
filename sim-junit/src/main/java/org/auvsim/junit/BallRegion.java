package org.auvsim.junit;

import static org.auvsim.junit.Figures.text;

import org.auvsim.core.math.Vec3;

import java.util.Optional;

/** What is near a point. */
record BallRegion(Vec3 centre, double distance) implements Region {
    BallRegion {
        Figures.requireLimit("a distance", distance, "m");
    }

    @Override
    public Optional<Breach> breach(double time, Vec3 position) {
        double actual = position.distance(centre);
        return actual <= distance
                ? Optional.empty()
                : Optional.of(
                        new Breach(
                                "gets away from " + text(centre),
                                text(actual) + " m away",
                                "at most %s m".formatted(text(distance))));
    }
}
