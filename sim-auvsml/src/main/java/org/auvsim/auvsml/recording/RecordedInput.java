package org.auvsim.auvsml.recording;

/** Something from outside that decided how the simulation went on, or may have. */
public sealed interface RecordedInput extends Entry
        permits ClientCame, ClientSent, ClientSentUnreadable, ClientWent, WaitTimedOut {
    /** Its place among the inputs since the last step, from 0. */
    int index();

    /** Whether it came while the next step waited for feedback. */
    boolean duringStep();
}
