package org.auvsim.server.replay;

import org.auvsim.auvsml.document.DocumentException;
import org.auvsim.auvsml.document.recording.RecordingReader;
import org.auvsim.auvsml.recording.Entry;

import java.util.Optional;

/** The entries of a recording, of which the next one can be looked at before it is taken. */
final class RecordedEntries {
    private final RecordingReader recording;
    private Optional<Entry> next = Optional.empty();
    private Optional<DocumentException> damage = Optional.empty();

    RecordedEntries(RecordingReader recording) {
        this.recording = recording;
        advance();
    }

    /** The next entry; empty at the end, or where the recording cannot be read. */
    Optional<Entry> next() {
        return next;
    }

    /** Passes over the next entry. */
    void advance() {
        try {
            next = recording.next();
        } catch (DocumentException e) {
            next = Optional.empty();
            damage = Optional.of(e);
        }
    }

    /**
     * Nothing, unless the end was reached as the recording cannot be read any further.
     *
     * @throws DocumentException in that case
     */
    void requireReadable() throws DocumentException {
        if (damage.isPresent()) {
            throw damage.get();
        }
    }
}
