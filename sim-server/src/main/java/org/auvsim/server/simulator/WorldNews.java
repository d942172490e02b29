package org.auvsim.server.simulator;

import org.auvsim.auvsml.message.command.EventType;
import org.auvsim.auvsml.message.entity.EntityAddedMessage;
import org.auvsim.auvsml.message.entity.EntityRemovedMessage;
import org.auvsim.auvsml.message.entity.WorldObjectAddedMessage;
import org.auvsim.auvsml.message.learning.ModelCorrection;
import org.auvsim.auvsml.message.learning.ModelCorrectionNotification;
import org.auvsim.auvsml.message.movement.CollisionNotification;
import org.auvsim.auvsml.message.movement.KinematicStateMessage;
import org.auvsim.auvsml.message.movement.MovementStateChangeMessage;
import org.auvsim.auvsml.message.movement.StateType;
import org.auvsim.auvsml.message.movement.StepReportNotification;
import org.auvsim.auvsml.message.movement.TimestepAdvancedNotification;
import org.auvsim.auvsml.message.radio.RadioMessage;
import org.auvsim.auvsml.message.sensing.SensorReadingMessage;
import org.auvsim.core.communication.TextMessage;
import org.auvsim.core.entity.Contact;
import org.auvsim.core.entity.Entity;
import org.auvsim.core.entity.MovementState;
import org.auvsim.core.entity.WorldObject;
import org.auvsim.core.step.Collision;
import org.auvsim.core.world.World;
import org.auvsim.core.world.WorldEvent;
import org.auvsim.core.world.WorldListener;
import org.auvsim.server.feedback.AppliedFeedback;
import org.auvsim.server.feedback.ProjectedWorld;
import org.auvsim.server.net.Notifications;

import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.stream.Collectors;

/**
 * Turns what happens in the world into messages. Collisions, arrivals, departures and reports are
 * told as they happen; movements when the step is made, since a step may have parts.
 */
final class WorldNews implements WorldListener {
    private final World world;
    private final Notifications notifications;
    private final Map<Long, WorldEvent.Moved> moved = new TreeMap<>();
    private boolean silent;

    WorldNews(World world, Notifications notifications) {
        this.world = world;
        this.notifications = notifications;
    }

    /** Lets something happen of which nobody is told. */
    void silently(Runnable what) {
        silent = true;
        try {
            what.run();
        } finally {
            silent = false;
        }
    }

    /** The ids of all entities. */
    Set<Long> entityIds() {
        return world.entities().stream().map(Entity::id).collect(Collectors.toSet());
    }

    /**
     * Tells how the world is now that it has changed otherwise than by a step: which entities have
     * come and gone, and where all objects are.
     *
     * @param known the ids of the entities that were there before
     */
    void present(Set<Long> known) {
        double time = world.time();
        known.stream()
                .sorted()
                .filter(id -> world.find(id).isEmpty())
                .forEach(id -> tell(new WorldEvent.EntityRemoved(time, id)));
        for (Entity entity : world.entities()) {
            if (!known.contains(entity.id())) {
                tell(new WorldEvent.EntityAdded(time, entity.id()));
                if (entity instanceof WorldObject object) {
                    tell(new WorldEvent.ObjectAdded(time, object.id(), object.position()));
                }
            }
        }
        for (WorldObject object : world.objects()) {
            if (!object.isFixed()) {
                moved(object.id());
            }
        }
        finished();
    }

    /** Sends what was told since the last time. */
    void flush() {
        notifications.flush();
    }

    @Override
    public void happened(WorldEvent event) {
        if (silent) {
            return;
        }
        switch (event) {
            case WorldEvent.EntityAdded added -> tell(added);
            case WorldEvent.ObjectAdded added -> tell(added);
            case WorldEvent.EntityRemoved removed -> tell(removed);
            case WorldEvent.Collided collided -> tell(collided);
            case WorldEvent.Moved movement -> moved.put(movement.objectId(), movement);
            case WorldEvent.SensorRead read -> tell(read);
            case WorldEvent.SignalReceived received -> {
                if (received.signal() instanceof TextMessage message) {
                    tell(received, message);
                }
            }
            case WorldEvent.StepReport report -> tell(report);
            case WorldEvent.StepAdvanced _ -> {
                // told when the whole step is over, see finished()
            }
        }
    }

    private void tell(WorldEvent.EntityAdded added) {
        notifications.event(
                EventType.ENTITY_ADDED,
                List.of(added.entityId()),
                added.time(),
                () -> new EntityAddedMessage(added.time(), added.entityId()));
    }

    private void tell(WorldEvent.ObjectAdded added) {
        notifications.event(
                EventType.ENTITY_ADDED,
                List.of(added.objectId()),
                added.time(),
                () ->
                        new WorldObjectAddedMessage(
                                added.time(), added.objectId(), added.position()));
    }

    private void tell(WorldEvent.EntityRemoved removed) {
        moved.remove(removed.entityId());
        notifications.event(
                EventType.ENTITY_REMOVED,
                List.of(removed.entityId()),
                removed.time(),
                () -> new EntityRemovedMessage(removed.time(), removed.entityId()));
    }

    private void tell(WorldEvent.Collided collided) {
        Collision collision = collided.collision();
        Contact contact = collision.contact();
        notifications.event(
                EventType.COLLISION,
                List.of(contact.self().id(), contact.other().id()),
                collided.time(),
                () -> CollisionNotification.of(collided.time(), collision));
    }

    private void tell(WorldEvent.SignalReceived received, TextMessage message) {
        notifications.event(
                EventType.RADIO,
                List.of(received.objectId()),
                received.time(),
                () ->
                        new RadioMessage(
                                received.time(),
                                received.objectId(),
                                message.senderId(),
                                message.sender(),
                                message.channel(),
                                message.sentAt(),
                                message.text()));
    }

    private void tell(WorldEvent.SensorRead read) {
        notifications.event(
                EventType.SENSOR_READING,
                List.of(read.objectId()),
                read.time(),
                () ->
                        new SensorReadingMessage(
                                read.time(),
                                read.objectId(),
                                read.sensor(),
                                read.measuredAt(),
                                read.reading()));
    }

    private void tell(WorldEvent.StepReport report) {
        notifications.stepReported(
                report.time(),
                () ->
                        new StepReportNotification(
                                report.time(),
                                report.subSteps(),
                                report.heldPairs(),
                                report.quickHits(),
                                report.crowdedHits(),
                                report.loweredHits(),
                                report.unsolvedIslands()));
    }

    /** Tells where the step will end. */
    void projected(ProjectedWorld projection) {
        double time = projection.time();
        projection
                .states()
                .forEach(
                        (id, state) ->
                                notifications.state(
                                        EventType.PROJECTED_MOVEMENT,
                                        id,
                                        time,
                                        () ->
                                                MovementStateChangeMessage.of(
                                                        time, id, true, state)));
        stepAdvanced(EventType.PROJECTED_MOVEMENT, time, StateType.PROJECTED);
    }

    /** Tells of the movements of a step that is made. */
    void advanced() {
        moved.values().forEach(movement -> tell(movement.objectId(), movement.state()));
        moved.clear();
    }

    /** Tells once more where an object is. */
    void moved(long objectId) {
        tell(objectId, world.object(objectId).movementState());
    }

    private void tell(long id, MovementState state) {
        double time = world.time();
        notifications.state(
                EventType.MOVEMENT_STATE_CHANGE,
                id,
                time,
                () -> MovementStateChangeMessage.of(time, id, false, state));
        notifications.state(
                EventType.KINEMATIC_STATE,
                id,
                time,
                () -> kinematics(time, world.object(id), state));
    }

    private static KinematicStateMessage kinematics(
            double time, WorldObject object, MovementState state) {
        var twist = object.twistOf(state);
        return new KinematicStateMessage(
                time,
                object.id(),
                state.position(),
                state.orientation(),
                twist.velocity(),
                twist.angularVelocity(),
                state.orientation().rotateInverse(twist.velocity()),
                state.orientation().rotateInverse(twist.angularVelocity()));
    }

    /** Tells of a correction. */
    void applied(AppliedFeedback applied) {
        notifications.event(
                EventType.FEEDBACK_APPLIED,
                List.of(applied.objectId()),
                applied.time(),
                applied::notification);
    }

    /** Tells what was found that the model of an object lacks. */
    void found(long objectId, ModelCorrection correction) {
        double time = world.time();
        notifications.event(
                EventType.MODEL_CORRECTION,
                List.of(objectId),
                time,
                () -> new ModelCorrectionNotification(objectId, time, correction));
    }

    /** Tells that the step is over. */
    void finished() {
        stepAdvanced(EventType.MOVEMENT_STATE_CHANGE, world.time(), StateType.ACTUAL);
    }

    private void stepAdvanced(EventType closes, double time, StateType type) {
        notifications.stepAdvanced(
                closes, time, () -> new TimestepAdvancedNotification(time, type));
    }
}
