package org.auvsim.auvsml.framing;

import org.auvsim.auvsml.Fault;

/** What a {@link FrameReader} found next in a stream. */
public sealed interface Frame {
    /**
     * The bytes of one root element, not yet looked into.
     *
     * @param line where it begins in the stream, from 1
     * @param column where it begins in that line, from 1
     */
    @SuppressWarnings("ArrayRecordComponent") // handed over, never compared
    record Root(byte[] bytes, int line, int column) implements Frame {}

    /** Something that is no root element; what follows is skipped up to the next one. */
    record Broken(Fault fault) implements Frame {}
}
