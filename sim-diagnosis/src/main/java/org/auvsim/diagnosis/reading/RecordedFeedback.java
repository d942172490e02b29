package org.auvsim.diagnosis.reading;

import org.auvsim.auvsml.document.DocumentException;
import org.auvsim.auvsml.document.recording.RecordingReader;
import org.auvsim.auvsml.mapping.AuvsmlMapper;
import org.auvsim.auvsml.message.Message;
import org.auvsim.auvsml.message.control.LoadScenarioCommand;
import org.auvsim.auvsml.message.control.ResetCommand;
import org.auvsim.auvsml.message.control.RestoreSnapshotCommand;
import org.auvsim.auvsml.recording.ClientSent;
import org.auvsim.auvsml.recording.Entry;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Optional;

/** What clients sent in a recording, until the world was replaced by another. */
final class RecordedFeedback {
    private final Path file;
    private final AuvsmlMapper mapper;

    /** Takes messages one by one. */
    interface Listener {
        /** A message that the simulator took at a time (s). */
        void sent(double time, Message message);
    }

    /** When the world was replaced; empty: it was not. */
    private Optional<Double> replaced = Optional.empty();

    RecordedFeedback(Path file, AuvsmlMapper mapper) {
        this.file = file;
        this.mapper = mapper;
    }

    /**
     * The id that the recorded world gives to a body.
     *
     * @throws DocumentException if it has none of this name
     */
    long idOf(String body) throws DocumentException {
        try (RecordingReader recording = RecordingReader.open(file, mapper)) {
            return recording.scenario().world().objects().stream()
                    .filter(object -> object.name().equals(body))
                    .findFirst()
                    .orElseThrow(
                            () ->
                                    new DocumentException(
                                            "%s: the recorded scenario has no world object '%s'"
                                                    .formatted(file, body)))
                    .id();
        } catch (IOException e) {
            throw CsvTable.unreadable(file, e);
        }
    }

    /** Tells all of them, from the beginning. */
    void tell(Listener listener) throws DocumentException {
        replaced = Optional.empty();
        try (RecordingReader recording = RecordingReader.open(file, mapper)) {
            Optional<Entry> entry = recording.next();
            while (entry.isPresent() && replaced.isEmpty()) {
                if (entry.get() instanceof ClientSent sent) {
                    tell(sent, listener);
                }
                entry = recording.next();
            }
        } catch (IOException e) {
            throw CsvTable.unreadable(file, e);
        }
    }

    private void tell(ClientSent sent, Listener listener) {
        for (Message message : sent.message()) {
            switch (message) {
                case ResetCommand _, RestoreSnapshotCommand _, LoadScenarioCommand _ ->
                        replaced = Optional.of(sent.timestamp());
                default -> {
                    if (replaced.isEmpty()) {
                        listener.sent(sent.timestamp(), message);
                    }
                }
            }
        }
    }

    /** The time (s) at which it was told no further, as the world was another one from there on. */
    Optional<Double> replaced() {
        return replaced;
    }
}
