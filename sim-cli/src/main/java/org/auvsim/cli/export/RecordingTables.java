package org.auvsim.cli.export;

import static java.nio.charset.StandardCharsets.UTF_8;

import org.auvsim.auvsml.document.DocumentException;
import org.auvsim.auvsml.document.recording.RecordingReader;
import org.auvsim.auvsml.mapping.AuvsmlMapper;
import org.auvsim.auvsml.message.Message;
import org.auvsim.auvsml.message.command.ListedWorldObject;
import org.auvsim.auvsml.message.entity.WorldObjectListResponse;
import org.auvsim.auvsml.message.feedback.FeedbackMessage;
import org.auvsim.auvsml.message.feedback.Measurement;
import org.auvsim.auvsml.message.movement.CollisionNotification;
import org.auvsim.auvsml.message.movement.MovementStateChangeMessage;
import org.auvsim.auvsml.recording.ClientCame;
import org.auvsim.auvsml.recording.ClientSent;
import org.auvsim.auvsml.recording.ClientSentUnreadable;
import org.auvsim.auvsml.recording.ClientWent;
import org.auvsim.auvsml.recording.Entry;
import org.auvsim.auvsml.recording.Happened;
import org.auvsim.auvsml.recording.RecordedInput;
import org.auvsim.core.description.ElementName;
import org.auvsim.core.math.Quat;

import java.io.IOException;
import java.util.EnumMap;
import java.util.HashMap;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;

/** Turns a recording's entries into rows, one after the other. */
final class RecordingTables {
    private final AuvsmlMapper mapper;
    private final TableWriter out;
    private final Map<Long, String> names = new HashMap<>();
    private final Map<Table, Long> rows = new EnumMap<>(Table.class);

    RecordingTables(AuvsmlMapper mapper, TableWriter out) {
        this.mapper = mapper;
        this.out = out;
    }

    /** Writes all entries; returns how many rows each table has got. */
    Map<Table, Long> write(RecordingReader recording) throws DocumentException, IOException {
        for (Table table : Table.values()) {
            rows.put(table, 0L);
        }
        for (Optional<Entry> next = recording.next(); next.isPresent(); next = recording.next()) {
            write(next.get());
        }
        return rows;
    }

    private void write(Entry entry) throws IOException {
        switch (entry) {
            case Happened happened -> {
                for (Message message : happened.message()) {
                    write(happened, message);
                }
            }
            case ClientSent sent -> {
                for (Message message : sent.message()) {
                    write(sent, message);
                }
            }
            case ClientSentUnreadable sent ->
                    append(
                            Table.MESSAGES,
                            place(sent, sent.sessionId())
                                    .text(sent.requestId())
                                    .add("unreadable")
                                    .add(sent.problem()));
            case ClientCame came ->
                    append(
                            Table.SESSIONS,
                            place(came, came.sessionId())
                                    .add("came")
                                    .add(came.peer())
                                    .add(came.role().roleName()));
            case ClientWent went ->
                    append(
                            Table.SESSIONS,
                            place(went, went.sessionId())
                                    .add("went")
                                    .text(Optional.empty())
                                    .text(Optional.empty()));
            default -> {}
        }
    }

    private void write(Happened place, Message message) throws IOException {
        switch (message) {
            case WorldObjectListResponse listed -> {
                for (ListedWorldObject object : listed.worldObject()) {
                    names.put(object.id(), object.name());
                }
            }
            case MovementStateChangeMessage moved ->
                    append(
                            Table.MOVEMENTS,
                            body(moment(place, moved.timestamp()), moved.worldObjectId())
                                    .add(moved.position())
                                    .add(Quat.of(moved.orientation()))
                                    .add(moved.linearMomentum())
                                    .add(moved.angularMomentum()));
            case CollisionNotification met ->
                    append(
                            Table.COLLISIONS,
                            body(
                                            body(moment(place, met.timestamp()), met.entityId()),
                                            met.otherId())
                                    .add(met.point())
                                    .add(met.normal())
                                    .add(met.impulse()));
            default -> {}
        }
    }

    private void write(ClientSent sent, Message message) throws IOException {
        String kind = ElementName.of(message.getClass());
        append(
                Table.MESSAGES,
                place(sent, sent.sessionId())
                        .text(sent.requestId())
                        .add(kind)
                        .add(new String(mapper.encodeLine((Record) message), UTF_8).strip()));
        if (message instanceof FeedbackMessage feedback) {
            append(Table.FEEDBACK, feedback(sent, kind, feedback));
        }
    }

    private Row feedback(ClientSent sent, String kind, FeedbackMessage feedback) {
        Measurement measured = feedback.measurement();
        return body(place(sent, sent.sessionId()), feedback.worldObjectId())
                .add(kind)
                .add(feedback.timestamp())
                .add(feedback.handlerName())
                .add(measured.frame().toString().toLowerCase(Locale.ROOT))
                .vector(measured.position())
                .orientation(measured.orientation())
                .vector(measured.velocity())
                .vector(measured.angularVelocity());
    }

    private void append(Table table, Row row) throws IOException {
        out.append(table, row);
        rows.merge(table, 1L, Long::sum);
    }

    private static Row moment(Happened place, double time) {
        return new Row().add(place.revision()).add(place.step()).add(time);
    }

    private static Row place(RecordedInput input, long session) {
        return new Row()
                .add(input.step())
                .add(input.index())
                .add(input.duringStep())
                .add(input.timestamp())
                .add(session);
    }

    /** Nobody has told the name of an entity that is no world object. */
    private Row body(Row row, long id) {
        return row.add(id).text(Optional.ofNullable(names.get(id)));
    }
}
