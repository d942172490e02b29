package org.auvsim.auvsml.message.sensing;

import org.auvsim.auvsml.message.Message;
import org.auvsim.core.description.Unit;
import org.auvsim.core.sensor.SensorReading;

/**
 * A reading arrived from a sensor of a world object.
 *
 * @param timestamp when it arrived
 * @param sensor its name
 * @param measuredAt when it was true: the sensor's delay before it arrived
 * @param reading what was read
 */
public record SensorReadingMessage(
        @Unit("s") double timestamp,
        long worldObjectId,
        String sensor,
        @Unit("s") double measuredAt,
        SensorReading reading)
        implements Message {}
