package org.auvsim.auvsml.document.recording;

import static java.nio.charset.StandardCharsets.UTF_8;

import org.auvsim.auvsml.document.Scenario;
import org.auvsim.auvsml.mapping.AuvsmlMapper;
import org.auvsim.auvsml.recording.Entry;
import org.auvsim.auvsml.recording.Recording;

import java.io.Closeable;
import java.io.IOException;
import java.io.OutputStream;

/**
 * Writes a recording: gzip members of AUVSML. What {@link #flush} has returned for is in the
 * stream's hands, whole and readable, whatever happens to this program afterwards.
 */
public final class RecordingWriter implements Closeable {
    /** A member is ended at this size (bytes) even if nobody asks for it. */
    private static final int MEMBER_BYTES = 4 << 20;

    private final OutputStream out;
    private final AuvsmlMapper mapper;
    private GzipMember member = new GzipMember();

    /** Writes to {@code out}, which {@link #close} closes. */
    public RecordingWriter(OutputStream out, AuvsmlMapper mapper) {
        this.out = out;
        this.mapper = mapper;
    }

    /**
     * Writes what a recording begins with.
     *
     * @throws IllegalArgumentException if the scenario has something that AUVSML cannot state
     */
    public void begin(Recording recording, Scenario scenario) throws IOException {
        member.add(mapper.encodeLine(recording));
        member.add(mapper.encode(scenario).getBytes(UTF_8));
        flush();
    }

    /**
     * Writes an entry.
     *
     * @throws IllegalArgumentException if it has something that AUVSML cannot state
     */
    public void write(Entry entry) throws IOException {
        member.add(mapper.encodeLine((Record) entry));
        if (member.length() >= MEMBER_BYTES) {
            flush();
        }
    }

    /** Ends the member that is open, if it has anything, and hands it to the stream. */
    public void flush() throws IOException {
        if (member.length() > 0) {
            GzipMember whole = member;
            member = new GzipMember();
            out.write(whole.finish());
            out.flush();
        }
    }

    @Override
    public void close() throws IOException {
        try (out) {
            flush();
        }
    }
}
