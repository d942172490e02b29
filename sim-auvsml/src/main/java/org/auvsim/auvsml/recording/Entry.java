package org.auvsim.auvsml.recording;

/** One thing that a recording tells, in the order in which they came to be. */
public sealed interface Entry permits RecordedInput, StepFailed, Happened, StateHash, RecordingEnded {
    /** So many steps had been made. */
    long step();

    /** The world's time (s). */
    double timestamp();
}
