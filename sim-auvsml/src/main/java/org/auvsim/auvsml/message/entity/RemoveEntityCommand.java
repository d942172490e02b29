package org.auvsim.auvsml.message.entity;

import org.auvsim.auvsml.message.Message;
import org.auvsim.auvsml.message.command.WorldCommand;
import org.auvsim.auvsml.message.command.WorldControl;

import java.util.Optional;

/** Takes an entity out of the world. */
public record RemoveEntityCommand(long entityId) implements WorldCommand {
    @Override
    public Optional<Message> execute(WorldControl world) {
        world.remove(entityId);
        return Optional.empty();
    }
}
