package org.auvsim.auvsml.message.entity;

import org.auvsim.auvsml.message.Message;
import org.auvsim.auvsml.message.command.WorldQuery;
import org.auvsim.auvsml.message.command.WorldView;

import java.util.Optional;

/** Asks for all world objects (thesis, section 7.1). */
public record GetWorldObjectListCommand() implements WorldQuery {
    @Override
    public Optional<Message> execute(WorldView world) {
        return Optional.of(new WorldObjectListResponse(world.worldObjects()));
    }
}
