package org.auvsim.core.step;

import org.auvsim.core.entity.RigidBody;

import java.util.Locale;

/**
 * Two bodies that share space.
 *
 * @param first the one with the lower id
 * @param depth how far (m) they would have to be moved apart
 */
public record Overlap(RigidBody first, RigidBody second, double depth) {
    /** The depth with its unit, for people. */
    public String depthInMetres() {
        return String.format(Locale.ROOT, "%.3g m", depth);
    }

    @Override
    public String toString() {
        return "'%s' (id %d) and '%s' (id %d) by %s"
                .formatted(first.name(), first.id(), second.name(), second.id(), depthInMetres());
    }
}
