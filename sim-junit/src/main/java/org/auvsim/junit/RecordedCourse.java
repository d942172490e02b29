package org.auvsim.junit;

import org.auvsim.auvsml.document.DocumentException;
import org.auvsim.auvsml.document.recording.Reach;
import org.auvsim.auvsml.document.recording.RecordingReader;
import org.auvsim.auvsml.message.Message;
import org.auvsim.auvsml.message.command.ListedWorldObject;
import org.auvsim.auvsml.message.entity.EntityRemovedMessage;
import org.auvsim.auvsml.message.entity.WorldObjectListResponse;
import org.auvsim.auvsml.message.movement.MovementStateChangeMessage;
import org.auvsim.auvsml.recording.Entry;
import org.auvsim.auvsml.recording.Happened;

import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;

/** Where a recording has its bodies, each at the beginning and after each step. */
final class RecordedCourse {
    private final Map<Long, RecordedBody> bodies = new TreeMap<>();
    private final Reach reach;

    /** Reads a recording to its end. */
    RecordedCourse(RecordingReader recording) throws DocumentException {
        for (Optional<Entry> next = recording.next(); next.isPresent(); next = recording.next()) {
            if (next.get() instanceof Happened happened) {
                happened.message().forEach(message -> take(happened, message));
            }
        }
        reach = recording.reach();
        bodies.values().forEach(body -> body.rests(reach.step(), reach.timestamp()));
    }

    private void take(Happened when, Message message) {
        switch (message) {
            case WorldObjectListResponse listed ->
                    listed.worldObject().stream().map(ListedWorldObject::id).forEach(this::body);
            case MovementStateChangeMessage moved ->
                    body(moved.worldObjectId())
                            .moved(
                                    when.revision(),
                                    when.step(),
                                    new Pose(
                                            moved.timestamp(),
                                            moved.position(),
                                            moved.orientation()));
            case EntityRemovedMessage removed ->
                    Optional.ofNullable(bodies.get(removed.entityId()))
                            .ifPresent(body -> body.left(when.step(), when.timestamp()));
            default -> {}
        }
    }

    private RecordedBody body(long id) {
        return bodies.computeIfAbsent(id, _ -> new RecordedBody());
    }

    /** How far it goes. */
    Reach reach() {
        return reach;
    }

    /** The body with an id; empty if the recording does not have it. */
    Optional<RecordedBody> find(long id) {
        return Optional.ofNullable(bodies.get(id));
    }
}
