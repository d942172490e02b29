package org.auvsim.auvsml.message.sensing;

import org.auvsim.auvsml.message.Message;
import org.auvsim.auvsml.message.command.WorldQuery;
import org.auvsim.auvsml.message.command.WorldView;
import org.auvsim.core.sensor.Sensor;

import java.util.Optional;

/** Asks for the sensors of a world object. */
public record GetSensorListRequest(long worldObjectId) implements WorldQuery {
    @Override
    public Optional<Message> execute(WorldView world) {
        return Optional.of(
                new SensorListResponse(
                        worldObjectId,
                        world.sensors(worldObjectId).stream()
                                .map(GetSensorListRequest::listed)
                                .toList()));
    }

    private static ListedSensor listed(Sensor sensor) {
        return new ListedSensor(
                sensor.name(), sensor.getClass().getSimpleName(), sensor.sampling().rate());
    }
}
