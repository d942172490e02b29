package org.auvsim.auvsml.recording;

/** One thing that a recording tells, in the order in which they came to be. */
public sealed interface Entry
        permits RecordedInput, StepFailed, Happened, StateHash, RecordingEnded {
    /**
     * How often late feedback had revised the past, or the world had been replaced by a snapshot or
     * another scenario's.
     */
    int revision();

    /** So many steps had been made. */
    long step();

    /** The world's time (s). */
    double timestamp();
}
