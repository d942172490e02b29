package org.auvsim.auvsml.document.recording;

import java.io.IOException;
import java.io.OutputStream;

/** A disk that takes so many bytes and no more. */
public final class SmallDisk extends OutputStream {
    private final OutputStream out;
    private int left;

    /** A file of at most {@code size} bytes, which go to {@code out}. */
    public SmallDisk(OutputStream out, int size) {
        this.out = out;
        this.left = size;
    }

    @Override
    public void write(int b) throws IOException {
        if (left == 0) {
            throw new IOException("No space left on device");
        }
        left--;
        out.write(b);
    }
}
