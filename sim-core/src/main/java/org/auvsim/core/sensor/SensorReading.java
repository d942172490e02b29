package org.auvsim.core.sensor;

/**
 * What a sensor read: a record, whose components are numbers, texts, vectors or records of these.
 *
 * <p>On the wire and in a CSV file it has the record's name. A user's own is listed in {@code
 * META-INF/services/org.auvsim.core.sensor.SensorReading}.
 */
public interface SensorReading {}
