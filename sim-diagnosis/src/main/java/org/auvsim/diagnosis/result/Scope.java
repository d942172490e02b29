package org.auvsim.diagnosis.result;

/** Which causes a sentence is about: of others it says nothing. */
public enum Scope {
    /** All that are known. */
    KNOWN,
    /** Those that were asked for. */
    REQUESTED,
    /** Those that were tried before the search was stopped. */
    TRIED
}
