package org.auvsim.auvsml.message.entity;

import org.auvsim.auvsml.message.Message;
import org.auvsim.auvsml.message.command.WorldQuery;
import org.auvsim.auvsml.message.command.WorldView;

import java.util.Optional;

/** Asks what acts on a world object. */
public record GetEffectListRequest(long worldObjectId) implements WorldQuery {
    @Override
    public Optional<Message> execute(WorldView world) {
        return Optional.of(new EffectListResponse(worldObjectId, world.effects(worldObjectId)));
    }
}
