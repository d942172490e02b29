package org.auvsim.server.replay;

import org.auvsim.auvsml.document.DocumentException;
import org.auvsim.auvsml.document.recording.RecordingReader;
import org.auvsim.auvsml.recording.Entry;
import org.auvsim.auvsml.recording.RecordedInput;
import org.auvsim.auvsml.recording.RecordingEnded;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Optional;

/** The entries of a recording, which can be looked at before they are taken. */
final class RecordedEntries {
    private final RecordingReader recording;

    /** Those that were read and not taken; but for the last, inputs during one step. */
    private final Deque<Entry> ahead = new ArrayDeque<>();

    private boolean isReadToItsEnd;
    private Optional<DocumentException> damage = Optional.empty();

    RecordedEntries(RecordingReader recording) {
        this.recording = recording;
        advance();
    }

    /** The next entry; empty at the end, or where the recording cannot be read. */
    Optional<Entry> next() {
        return Optional.ofNullable(ahead.peek());
    }

    /** Passes over the next entry. */
    void advance() {
        ahead.poll();
        if (ahead.isEmpty()) {
            read();
        }
    }

    /**
     * Whether nothing tells that the step after so many others was made or failed: the recording
     * ends here, or with inputs for which the step waited.
     */
    boolean endBeforeStepAfter(long steps) {
        while (ahead.isEmpty() || isInputDuringStepAfter(steps, ahead.getLast())) {
            if (!read()) {
                return true;
            }
        }
        return ahead.getLast() instanceof RecordingEnded end && end.step() <= steps;
    }

    private static boolean isInputDuringStepAfter(long steps, Entry entry) {
        return entry instanceof RecordedInput input && input.duringStep() && input.step() == steps;
    }

    /** Whether there was one more entry. */
    private boolean read() {
        if (isReadToItsEnd) {
            return false;
        }
        try {
            Optional<Entry> entry = recording.next();
            entry.ifPresent(ahead::add);
            isReadToItsEnd = entry.isEmpty();
        } catch (DocumentException e) {
            damage = Optional.of(e);
            isReadToItsEnd = true;
        }
        return !isReadToItsEnd;
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
