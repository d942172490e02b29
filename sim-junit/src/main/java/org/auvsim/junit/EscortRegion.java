package org.auvsim.junit;

import static org.auvsim.junit.Figures.text;

import org.auvsim.core.math.Vec3;

import java.util.Optional;

/** What is near another body at the same time. */
record EscortRegion(Trajectory other, double distance) implements Region {
    EscortRegion {
        Figures.requireLimit("a distance", distance, "m");
    }

    @Override
    public Optional<Breach> breach(double time, Vec3 position) {
        String allowed = "at most %s m".formatted(text(distance));
        if (!other.isThereAt(time)) {
            return breach("which is not in the world", allowed);
        }
        double actual = position.distance(other.at(time).position());
        return actual <= distance
                ? Optional.empty()
                : breach(text(actual) + " m from origin to origin", allowed);
    }

    private Optional<Breach> breach(String actual, String allowed) {
        return Optional.of(
                new Breach("gets away from '%s'".formatted(other.name()), actual, allowed));
    }
}
