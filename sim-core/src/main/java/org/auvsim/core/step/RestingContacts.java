package org.auvsim.core.step;

/** Placeholder. */
final class RestingContacts {
    /** The gap (m) that resting contacts keep open, as a share of the smaller bounding radius. */
    static final double MARGIN = 1e-5;
}
