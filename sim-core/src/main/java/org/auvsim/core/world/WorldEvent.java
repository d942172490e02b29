package org.auvsim.core.world;

import org.auvsim.core.entity.MovementState;
import org.auvsim.core.entity.Signal;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.sensor.SensorReading;
import org.auvsim.core.step.Collision;
import org.auvsim.core.step.StepStatistics;

/** Something that happened in a world, told to its listeners after the step. */
public sealed interface WorldEvent {
    /** World time (s) at which it happened. */
    double time();

    /** An entity has been added. */
    record EntityAdded(double time, long entityId) implements WorldEvent {}

    /** A world object has been added; follows its {@link EntityAdded}. */
    record ObjectAdded(double time, long objectId, Vec3 position) implements WorldEvent {}

    /** An entity has left. */
    record EntityRemoved(double time, long entityId) implements WorldEvent {}

    /** Two collidables have collided and responded. */
    record Collided(double time, Collision collision) implements WorldEvent {}

    /** A world object has moved, or its momenta have changed. */
    record Moved(double time, long objectId, MovementState state) implements WorldEvent {}

    /** A signal, such as a message, has reached a world object. */
    record SignalReceived(double time, long objectId, Signal signal) implements WorldEvent {}

    /**
     * A reading has arrived from a sensor.
     *
     * @param time at which it arrived, the sensor's delay after {@code measuredAt}
     */
    record SensorRead(
            double time, long objectId, String sensor, double measuredAt, SensorReading reading)
            implements WorldEvent {}

    /**
     * How a step was kept from getting stuck or diverging, counted as in {@link StepStatistics}; a
     * step that needed nothing of it is not reported. Follows the movements.
     */
    record StepReport(
            double time,
            long subSteps,
            long heldPairs,
            long quickHits,
            long crowdedHits,
            long loweredHits,
            long unsolvedIslands)
            implements WorldEvent {}

    /** A step is done; the last event of a step. */
    record StepAdvanced(double time, double elapsed) implements WorldEvent {}
}
