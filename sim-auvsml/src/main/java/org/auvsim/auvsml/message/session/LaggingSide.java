package org.auvsim.auvsml.message.session;

/** Who is too slow. */
public enum LaggingSide {
    /** The client does not read fast enough. */
    CLIENT,
    /** The simulator does not make steps fast enough. */
    SIMULATOR
}
