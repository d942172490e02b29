package org.auvsim.auvsml.document.recording;

import org.auvsim.auvsml.document.DocumentException;

import java.io.IOException;
import java.util.Optional;

/** A recording's text, piece by piece. */
interface Blocks {
    /**
     * The next piece, never without bytes; empty at the end.
     *
     * @throws DocumentException if the file is damaged here
     */
    Optional<byte[]> next() throws IOException, DocumentException;

    /** Whether the last root element may be incomplete, as no checksum covers it. */
    boolean mayEndAnywhere();
}
