package org.auvsim.diagnosis.model;

import org.auvsim.diagnosis.run.Channel;

/**
 * How old what is told is; below 0: how far ahead.
 *
 * @param ofAll by which all is old (s)
 * @param ofPositions by which positions are older still (s)
 * @param ofOrientations by which orientations are older still (s)
 */
record Lateness(double ofAll, double ofPositions, double ofOrientations) {
    /** Told at once. */
    static final Lateness NONE = new Lateness(0, 0, 0);

    /** Both, one on top of the other. */
    Lateness plus(Lateness more) {
        return new Lateness(
                ofAll + more.ofAll,
                ofPositions + more.ofPositions,
                ofOrientations + more.ofOrientations);
    }

    /** How old what is told of a channel is (s). */
    double of(Channel channel) {
        return switch (channel) {
            case POSITION -> ofAll + ofPositions;
            case ORIENTATION -> ofAll + ofOrientations;
            case VELOCITY, ANGULAR_VELOCITY -> ofAll;
        };
    }
}
