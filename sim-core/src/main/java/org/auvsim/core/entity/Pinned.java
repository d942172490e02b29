package org.auvsim.core.entity;

import org.auvsim.core.math.Vec3;

import java.util.List;
import java.util.Optional;

/**
 * Pinned at its origin, which stays where it is.
 *
 * @param axis about which alone it turns (world axes), any length above 0; empty: about any
 */
public record Pinned(Optional<Vec3> axis) implements Mount {
    /**
     * A checked pin.
     *
     * @throws IllegalArgumentException if the axis has no direction
     */
    public Pinned {
        if (axis.isPresent() && !(axis.get().norm() > 0 && axis.get().isFinite())) {
            throw new IllegalArgumentException(
                    "the axis of a pin needs a finite length above 0, but is " + axis.get());
        }
    }

    @Override
    public List<Vec3> freeTranslations() {
        return List.of();
    }

    @Override
    public List<Vec3> freeRotations() {
        return axis.map(a -> List.of(a.normalized())).orElse(Held.AXES);
    }
}
