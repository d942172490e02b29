package org.auvsim.auvsml.message.sensing;

import org.auvsim.auvsml.message.Message;

import java.util.List;

/** The sensors of a world object. */
public record SensorListResponse(long worldObjectId, List<ListedSensor> sensor)
        implements Message {}
