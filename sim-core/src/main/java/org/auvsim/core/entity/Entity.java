package org.auvsim.core.entity;

/**
 * Anything that is in a world (thesis, section 6.1).
 *
 * <p>Rigid bodies are live views; every other entity is an immutable value, so that worlds can
 * share it; one that changes is replaced by its changed self ({@link Change.Update}).
 */
public interface Entity {
    /** A positive number, unique in its world and never used again there. */
    long id();

    /** A name for people, unique in its world. */
    String name();

    /** Whether it has had its time at {@code time} (s) and leaves the world, as a wave does. */
    default boolean isOver(double time) {
        return false;
    }
}
