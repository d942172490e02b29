package org.auvsim.core.entity;

import java.util.Optional;

/**
 * A capability of a world object: a propulsor, a behavior, a sensor (thesis, section 6.3).
 *
 * <p>Components are immutable values; one that changes is replaced by its changed self ({@link
 * WorldObject#replace}). So a copy of a world shares them.
 */
public interface Component {
    /** A name for people and commands, unique in its object. */
    String name();

    /** The other component that this one cannot do without, if any. */
    default Optional<Need> needs() {
        return Optional.empty();
    }
}
