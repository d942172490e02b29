package org.auvsim.auvsml.message.command;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;

/** The events that a client can register for, and their names in AUVSML. */
public enum EventType {
    /** An object's state after a step. */
    MOVEMENT_STATE_CHANGE("MovementStateChange"),
    /** An object's state as the step will end without feedback. */
    PROJECTED_MOVEMENT("ProjectedMovement"),
    /** An object's velocities after a step. */
    KINEMATIC_STATE("KinematicState"),
    /** A step is done; belongs to no object. */
    TIMESTEP_ADVANCED("TimestepAdvanced"),
    /** How a step was kept from getting stuck or diverging; belongs to no object. */
    STEP_REPORT("StepReport"),
    /** Two entities met. */
    COLLISION("Collision"),
    /** A reading arrived from a sensor of an object. */
    SENSOR_READING("SensorReading"),
    /** A message of a modem or a radio reached an object. */
    RADIO("Radio"),
    /** An entity came into the world. */
    ENTITY_ADDED("EntityAdded"),
    /** An entity left the world. */
    ENTITY_REMOVED("EntityRemoved"),
    /** A feedback processor used a client's feedback. */
    FEEDBACK_APPLIED("FeedbackApplied"),
    /** It was found out what the model of an object lacks. */
    MODEL_CORRECTION("ModelCorrection");

    private final String eventName;

    EventType(String eventName) {
        this.eventName = eventName;
    }

    /** Its name in AUVSML, as {@code MovementStateChange}. */
    public String eventName() {
        return eventName;
    }

    /** The type of this name. */
    public static Optional<EventType> named(String eventName) {
        return Arrays.stream(values()).filter(t -> t.eventName.equals(eventName)).findFirst();
    }

    /** All names, {@link Listener#ALL} first. */
    public static List<String> names() {
        return Stream.concat(
                        Stream.of(Listener.ALL), Arrays.stream(values()).map(EventType::eventName))
                .toList();
    }
}
