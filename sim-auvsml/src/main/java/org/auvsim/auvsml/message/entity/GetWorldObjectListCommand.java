package org.auvsim.auvsml.message.entity;

import org.auvsim.auvsml.message.Message;
import org.auvsim.auvsml.message.command.WorldCommand;
import org.auvsim.auvsml.message.command.WorldControl;

import java.util.Optional;

/** Asks for all world objects (thesis, section 7.1). */
public record GetWorldObjectListCommand() implements WorldCommand {
    @Override
    public Optional<Message> execute(WorldControl world) {
        return Optional.of(new WorldObjectListResponse(world.worldObjects()));
    }
}
