package org.auvsim.junit;

import static org.auvsim.junit.Figures.text;

import org.auvsim.core.math.Vec3;

import java.util.Optional;

/** A box along the world's axes. */
record BoxRegion(Vec3 low, Vec3 high) implements Region {
    BoxRegion {
        requireRoom("x", low.x(), high.x());
        requireRoom("y", low.y(), high.y());
        requireRoom("z", low.z(), high.z());
    }

    private static void requireRoom(String axis, double low, double high) {
        if (!(low <= high)) {
            throw new IllegalArgumentException(
                    "a box's low %s must not be above its high one, but they are %s and %s m"
                            .formatted(axis, low, high));
        }
    }

    @Override
    public Optional<Breach> breach(double time, Vec3 position) {
        return along("x", position.x(), low.x(), high.x())
                .or(() -> along("y", position.y(), low.y(), high.y()))
                .or(() -> along("z", position.z(), low.z(), high.z()));
    }

    private static Optional<Breach> along(String axis, double value, double low, double high) {
        if (value >= low && value <= high) {
            return Optional.empty();
        }
        return Optional.of(
                new Breach(
                        "leaves the box",
                        "%s = %s m".formatted(axis, text(value)),
                        "%s to %s m".formatted(text(low), text(high))));
    }
}
