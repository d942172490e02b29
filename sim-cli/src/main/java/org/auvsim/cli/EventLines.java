package org.auvsim.cli;

import org.auvsim.auvsml.message.Message;
import org.auvsim.auvsml.message.control.SnapshotRestoredNotification;
import org.auvsim.auvsml.message.entity.EntityAddedMessage;
import org.auvsim.auvsml.message.entity.EntityRemovedMessage;
import org.auvsim.auvsml.message.feedback.FeedbackAppliedNotification;
import org.auvsim.auvsml.message.movement.CollisionNotification;
import org.auvsim.auvsml.message.movement.MovementStateChangeMessage;
import org.auvsim.auvsml.message.movement.StepReportNotification;
import org.auvsim.auvsml.message.radio.RadioMessage;
import org.auvsim.auvsml.message.sensing.SensorReadingMessage;
import org.auvsim.auvsml.message.session.DisconnectedNotification;
import org.auvsim.auvsml.message.session.ErrorResponse;
import org.auvsim.auvsml.message.session.LaggingNotification;
import org.auvsim.auvsml.message.session.LaggingSide;
import org.auvsim.core.math.Mat3;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.sensor.SensorReading;

import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.stream.Collectors;

/** Messages of a simulator as lines of a table for people. */
final class EventLines {
    /** The table's first line. */
    static final String HEADER =
            "%10s  %-16s %-9s %12s %12s %12s %8s %8s %8s"
                    .formatted(
                            "time s", "object", "state", "x m", "y m", "z m", "roll", "pitch",
                            "yaw");

    private final Map<Long, String> names = new HashMap<>();

    /** For a simulator that has these objects. */
    EventLines(List<ServedObject> objects) {
        objects.forEach(object -> names.put(object.id(), object.name()));
    }

    /** The line of a message; empty for one that is not for people. */
    Optional<String> of(Message message) {
        return switch (message) {
            case MovementStateChangeMessage m -> Optional.of(movement(m));
            case CollisionNotification c ->
                    event(
                            c.timestamp(),
                            c.entityId(),
                            String.format(
                                    Locale.ROOT,
                                    "collides with %s, impulse %.4g N s",
                                    name(c.otherId()),
                                    c.impulse().norm()));
            case EntityAddedMessage a -> event(a.timestamp(), a.entityId(), "was added");
            case EntityRemovedMessage r -> event(r.timestamp(), r.entityId(), "was removed");
            case FeedbackAppliedNotification f ->
                    event(
                            f.timestamp(),
                            f.worldObjectId(),
                            "was corrected by " + f.handlerName() + errors(f));
            case RadioMessage r ->
                    event(
                            r.timestamp(),
                            r.worldObjectId(),
                            "hears %s: %s".formatted(name(r.senderId()), r.text()));
            case SensorReadingMessage r ->
                    event(
                            r.measuredAt(),
                            r.worldObjectId(),
                            "reads %s: %s".formatted(r.sensor(), values(r.reading())));
            case StepReportNotification s ->
                    event(
                            s.timestamp(),
                            "(step)",
                            ("sub-steps %d, contacts held %d, quick hits %d, crowded hits %d,"
                                            + " lowered hits %d, islands unsolved %d")
                                    .formatted(
                                            s.subSteps(),
                                            s.heldPairs(),
                                            s.quickHits(),
                                            s.crowdedHits(),
                                            s.loweredHits(),
                                            s.unsolvedIslands()));
            case LaggingNotification l ->
                    Optional.of(
                            l.side() == LaggingSide.CLIENT
                                    ? "(too slow here: %d movements were not told"
                                                    .formatted(l.skipped())
                                            + ", which newer ones replaced)"
                                    : "(the simulator is too slow: %d steps more behind its rate)"
                                            .formatted(l.skipped()));
            case SnapshotRestoredNotification s ->
                    Optional.of("(time goes on from %s s: %s)".formatted(s.timestamp(), s.name()));
            case DisconnectedNotification d -> Optional.of("the simulator ends: " + d.reason());
            case ErrorResponse e -> Optional.of("the simulator refuses: " + e.text());
            default -> Optional.empty();
        };
    }

    private static String errors(FeedbackAppliedNotification f) {
        return error("error", "m", f.errorBefore(), f.errorAfter())
                + error("angle", "rad", f.angleErrorBefore(), f.angleErrorAfter())
                + error("velocity", "m/s", f.velocityErrorBefore(), f.velocityErrorAfter())
                + error(
                        "angular velocity",
                        "rad/s",
                        f.angularVelocityErrorBefore(),
                        f.angularVelocityErrorAfter())
                + (f.converged() ? "" : ", not all that it aimed at");
    }

    private static String error(
            String what, String unit, OptionalDouble before, OptionalDouble after) {
        return before.isPresent() && after.isPresent()
                ? String.format(
                        Locale.ROOT,
                        ", %s %.4g %s before, %.4g %s after",
                        what,
                        before.getAsDouble(),
                        unit,
                        after.getAsDouble(),
                        unit)
                : "";
    }

    private static String values(SensorReading reading) {
        return Quantities.of(reading).entrySet().stream()
                .map(value -> value.getKey() + " " + value.getValue())
                .collect(Collectors.joining(", "));
    }

    private String name(long id) {
        return names.getOrDefault(id, "#" + id);
    }

    private Optional<String> event(double time, long id, String what) {
        return event(time, name(id), what);
    }

    private static Optional<String> event(double time, String who, String what) {
        return Optional.of(String.format(Locale.ROOT, "%10.3f  %-16s %s", time, who, what));
    }

    private String movement(MovementStateChangeMessage m) {
        Vec3 p = m.position();
        Mat3 r = m.orientation();
        return String.format(
                Locale.ROOT,
                "%10.3f  %-16s %-9s %12.4f %12.4f %12.4f %8.2f %8.2f %8.2f",
                m.timestamp(),
                name(m.worldObjectId()),
                m.isProjectedState() ? "projected" : "actual",
                p.x(),
                p.y(),
                p.z(),
                Math.toDegrees(Math.atan2(r.zy(), r.zz())),
                Math.toDegrees(Math.asin(Math.clamp(0 - r.zx(), -1, 1))),
                Math.toDegrees(Math.atan2(r.yx(), r.xx())));
    }
}
