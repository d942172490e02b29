package org.auvsim.diagnosis.reading;

import org.auvsim.auvsml.document.DocumentException;
import org.auvsim.auvsml.document.recording.RecordingReader;
import org.auvsim.auvsml.mapping.AuvsmlMapper;
import org.auvsim.auvsml.message.Message;
import org.auvsim.auvsml.message.control.LoadScenarioCommand;
import org.auvsim.auvsml.message.control.ResetCommand;
import org.auvsim.auvsml.message.control.RestoreSnapshotCommand;
import org.auvsim.auvsml.message.feedback.FeedbackMessage;
import org.auvsim.auvsml.recording.ClientSent;
import org.auvsim.auvsml.recording.Entry;
import org.auvsim.core.entity.WorldObject;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** What clients sent in a recording, until the world was replaced by another. */
final class RecordedFeedback {
    private final Path file;
    private final AuvsmlMapper mapper;

    /** Takes messages one by one. */
    interface Listener {
        /** A message, and the time (s) from which on it acts. */
        void sent(double time, Message message);
    }

    /** When the world was replaced; empty: it was not. */
    private Optional<Double> replaced = Optional.empty();

    /** Commands that came during a step, and that step. */
    private final List<Message> waiting = new ArrayList<>();

    private long stepOfWaiting;

    RecordedFeedback(Path file, AuvsmlMapper mapper) {
        this.file = file;
        this.mapper = mapper;
    }

    /**
     * A body as the recorded world begins with it.
     *
     * @throws DocumentException if it has none of this name
     */
    WorldObject object(String body) throws DocumentException {
        try (RecordingReader recording = RecordingReader.open(file, mapper)) {
            return recording.scenario().world().objects().stream()
                    .filter(object -> object.name().equals(body))
                    .findFirst()
                    .orElseThrow(
                            () ->
                                    new DocumentException(
                                            "%s: the recorded scenario has no world object '%s'"
                                                    .formatted(file, body)));
        } catch (IOException e) {
            throw CsvTable.unreadable(file, e);
        }
    }

    /** Tells all of them, from the beginning. */
    void tell(Listener listener) throws DocumentException {
        replaced = Optional.empty();
        waiting.clear();
        try (RecordingReader recording = RecordingReader.open(file, mapper)) {
            Optional<Entry> entry = recording.next();
            while (entry.isPresent() && replaced.isEmpty()) {
                tell(entry.get(), listener);
                entry = recording.next();
            }
        } catch (IOException e) {
            throw CsvTable.unreadable(file, e);
        }
    }

    /** What came while a step waited for feedback acts from the step's end on. */
    private void tell(Entry entry, Listener listener) {
        if (!waiting.isEmpty() && entry.step() > stepOfWaiting) {
            waiting.forEach(message -> listener.sent(entry.timestamp(), message));
            waiting.clear();
        }
        if (entry instanceof ClientSent sent) {
            sent.message().forEach(message -> tell(sent, message, listener));
        }
    }

    private void tell(ClientSent sent, Message message, Listener listener) {
        switch (message) {
            case ResetCommand _, RestoreSnapshotCommand _, LoadScenarioCommand _ ->
                    replaced = Optional.of(sent.timestamp());
            case FeedbackMessage feedback -> listener.sent(sent.timestamp(), feedback);
            default -> {
                if (sent.duringStep()) {
                    waiting.add(message);
                    stepOfWaiting = sent.step();
                } else {
                    listener.sent(sent.timestamp(), message);
                }
            }
        }
    }

    /** The time (s) at which it was told no further, as the world was another one from there on. */
    Optional<Double> replaced() {
        return replaced;
    }
}
