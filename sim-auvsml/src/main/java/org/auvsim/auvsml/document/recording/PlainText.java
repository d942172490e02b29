package org.auvsim.auvsml.document.recording;

import java.io.IOException;
import java.io.InputStream;
import java.util.Optional;

/** A recording that is not compressed: unpacked or written by hand. */
record PlainText(InputStream in) implements Blocks {
    private static final int PIECE = 1 << 16;

    @Override
    public Optional<byte[]> next() throws IOException {
        return Optional.of(in.readNBytes(PIECE)).filter(piece -> piece.length > 0);
    }

    @Override
    public boolean mayEndAnywhere() {
        return true;
    }
}
