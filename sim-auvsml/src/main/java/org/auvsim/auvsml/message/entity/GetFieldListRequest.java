package org.auvsim.auvsml.message.entity;

import org.auvsim.auvsml.message.Message;
import org.auvsim.auvsml.message.command.WorldCommand;
import org.auvsim.auvsml.message.command.WorldControl;

import java.util.Optional;

/** Asks which fields fill the world. */
public record GetFieldListRequest() implements WorldCommand {
    @Override
    public Optional<Message> execute(WorldControl world) {
        return Optional.of(new FieldListResponse(world.fields()));
    }
}
