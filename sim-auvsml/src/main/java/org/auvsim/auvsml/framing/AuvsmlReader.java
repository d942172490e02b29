package org.auvsim.auvsml.framing;

import org.auvsim.auvsml.xml.Limits;

import java.io.IOException;
import java.io.InputStream;
import java.util.Optional;

/**
 * Reads messages from a stream, blocking until the next one is there: made for one virtual thread a
 * connection, which calls {@link #next()} until {@link Incoming.End}.
 */
public final class AuvsmlReader {
    private static final int PACKET = 8192;

    private final InputStream in;
    private final RootDecoder decoder;
    private final FrameReader frames;
    private final byte[] packet = new byte[PACKET];
    private boolean ended;

    /** Reads from {@code in}, which the caller closes. */
    public AuvsmlReader(InputStream in, RootDecoder decoder, Limits limits) {
        this.in = in;
        this.decoder = decoder;
        this.frames = new FrameReader(limits);
    }

    /**
     * What comes next.
     *
     * @throws IOException if the stream breaks off
     */
    public Incoming next() throws IOException {
        Optional<Frame> frame = frames.next();
        while (frame.isEmpty() && !ended) {
            int length = in.read(packet);
            if (length < 0) {
                ended = true;
                frames.end();
            } else {
                frames.feed(packet, 0, length);
            }
            frame = frames.next();
        }
        return frame.map(decoder::decode).orElseGet(Incoming.End::new);
    }
}
