package org.auvsim.auvsml.message.entity;

import org.auvsim.auvsml.message.Message;
import org.auvsim.auvsml.message.command.WorldQuery;
import org.auvsim.auvsml.message.command.WorldView;

import java.util.Optional;

/** Asks for a world object as it is now, described as in a scenario. */
public record DescribeWorldObjectRequest(long worldObjectId) implements WorldQuery {
    @Override
    public Optional<Message> execute(WorldView world) {
        return Optional.of(new WorldObjectDescriptionResponse(world.description(worldObjectId)));
    }
}
