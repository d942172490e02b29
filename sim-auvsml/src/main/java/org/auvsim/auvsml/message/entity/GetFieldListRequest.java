package org.auvsim.auvsml.message.entity;

import org.auvsim.auvsml.message.Message;
import org.auvsim.auvsml.message.command.WorldQuery;
import org.auvsim.auvsml.message.command.WorldView;

import java.util.Optional;

/** Asks which fields fill the world. */
public record GetFieldListRequest() implements WorldQuery {
    @Override
    public Optional<Message> execute(WorldView world) {
        return Optional.of(new FieldListResponse(world.fields()));
    }
}
