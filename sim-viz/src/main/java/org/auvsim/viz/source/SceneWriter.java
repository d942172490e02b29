package org.auvsim.viz.source;

import org.auvsim.auvsml.message.Message;
import org.auvsim.auvsml.message.control.SnapshotRestoredNotification;
import org.auvsim.auvsml.message.entity.EntityRemovedMessage;
import org.auvsim.auvsml.message.entity.FieldListResponse;
import org.auvsim.auvsml.message.entity.WorldObjectDescriptionResponse;
import org.auvsim.auvsml.message.feedback.FeedbackAppliedNotification;
import org.auvsim.auvsml.message.learning.ModelCorrectionNotification;
import org.auvsim.auvsml.message.lockstep.LockstepTimeoutNotification;
import org.auvsim.auvsml.message.movement.CollisionNotification;
import org.auvsim.auvsml.message.movement.KinematicStateMessage;
import org.auvsim.auvsml.message.movement.MovementStateChangeMessage;
import org.auvsim.auvsml.message.movement.StateType;
import org.auvsim.auvsml.message.movement.TimestepAdvancedNotification;
import org.auvsim.auvsml.message.radio.RadioMessage;
import org.auvsim.auvsml.message.session.ErrorResponse;
import org.auvsim.auvsml.message.session.LaggingNotification;
import org.auvsim.auvsml.message.session.RecordingEndedNotification;
import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.viz.scene.Counted;
import org.auvsim.viz.scene.Meeting;
import org.auvsim.viz.scene.Movement;
import org.auvsim.viz.scene.Occurrence;
import org.auvsim.viz.scene.Scene;
import org.auvsim.viz.scene.SeenObject;

import java.util.List;

/** Writes what a simulator tells into a scene. Belongs to the thread that reads. */
final class SceneWriter {
    private final Scene scene;
    private double newest = Double.NEGATIVE_INFINITY;
    private boolean moved;

    SceneWriter(Scene scene) {
        this.scene = scene;
    }

    void write(Message message) {
        switch (message) {
            case KinematicStateMessage m -> moved(m);
            case MovementStateChangeMessage m -> projected(m);
            case TimestepAdvancedNotification m -> advanced(m);
            case CollisionNotification m -> met(m);
            case FeedbackAppliedNotification m ->
                    m.measuredPosition()
                            .ifPresent(p -> scene.measure(m.worldObjectId(), m.timestamp(), p));
            case WorldObjectDescriptionResponse m -> described(m.worldObject());
            case FieldListResponse m -> scene.setFields(m.field());
            case EntityRemovedMessage m -> scene.remove(m.entityId());
            case SnapshotRestoredNotification m -> restored(m);
            case ModelCorrectionNotification m ->
                    tell(m.timestamp(), name(m.worldObjectId()) + m.modelCorrection().sentence());
            case RadioMessage m ->
                    tell(m.timestamp(), name(m.worldObjectId()) + "hears \"" + m.text() + "\"");
            case LaggingNotification m -> tell(newest(), words(m));
            case RecordingEndedNotification m -> tell(newest(), m.reason());
            case LockstepTimeoutNotification m ->
                    tell(newest(), "Step %d waits for members".formatted(m.step()));
            default -> {}
        }
    }

    /** What went wrong though nobody asked for it: a step that failed, for example. */
    void tellFaults(List<Message> messages) {
        for (Message message : messages) {
            if (message instanceof ErrorResponse error) {
                tell(newest(), "The simulator says: " + error.text());
            }
        }
    }

    private double newest() {
        return Math.max(newest, 0);
    }

    private String name(long id) {
        return scene.object(id).map(SeenObject::name).orElse("#" + id) + ": ";
    }

    private void tell(double time, String text) {
        scene.tell(new Occurrence(time, text));
    }

    private void described(WorldObjectDefinition definition) {
        definition.id().ifPresent(id -> scene.add(SeenObject.of(id, definition)));
    }

    private void moved(KinematicStateMessage m) {
        scene.move(
                m.worldObjectId(),
                new Movement(
                        m.timestamp(),
                        m.position(),
                        m.quaternion(),
                        m.velocity(),
                        m.angularVelocity()));
        newest = m.timestamp();
        moved = true;
    }

    private void projected(MovementStateChangeMessage m) {
        if (m.isProjectedState()) {
            scene.project(
                    m.worldObjectId(),
                    new Movement(
                            m.timestamp(),
                            m.position(),
                            Quat.of(m.orientation()),
                            Vec3.ZERO,
                            Vec3.ZERO));
        }
    }

    /** Steps that moved nothing, or whose states were left out, are not shown one by one. */
    private void advanced(TimestepAdvancedNotification m) {
        if (m.stateType() == StateType.ACTUAL && moved) {
            scene.stepDone(newest, System.nanoTime());
            moved = false;
        }
    }

    private void met(CollisionNotification m) {
        scene.meet(new Meeting(m.timestamp(), m.entityId(), m.otherId(), m.point(), m.impulse()));
    }

    private void restored(SnapshotRestoredNotification m) {
        scene.jumpTo(m.timestamp());
        newest = m.timestamp();
        moved = false;
        tell(m.timestamp(), "Time goes on from here: " + origin(m.name()));
    }

    private static String words(LaggingNotification m) {
        return switch (m.side()) {
            case CLIENT ->
                    ("This viewer is too slow: it was not told of %s, which newer ones replaced;"
                                    + " the world is right.")
                            .formatted(Counted.of(m.skipped(), "movement"));
            case SIMULATOR ->
                    ("The simulator is too slow for its rate: the world's time has fallen behind"
                                    + " by %s more; every step is made.")
                            .formatted(Counted.of(m.skipped(), "step"));
        };
    }

    /** From where it goes on; the simulator's own names stand for what is no snapshot. */
    private static String origin(String name) {
        return switch (name) {
            case "*BEGINNING*" -> "the beginning of the world";
            case "*SCENARIO*" -> "another scenario";
            default -> "the snapshot '" + name + "'";
        };
    }
}
