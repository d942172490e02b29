package org.auvsim.core.entity;

/** The axes in which a vector is given (thesis, section 4.1). */
public enum Frame {
    /** Fixed to the world: x east, y north, z up. */
    WORLD,
    /** Turning with the body: x forward, y left, z up. */
    BODY
}
