package org.auvsim.auvsml.message.entity;

import org.auvsim.auvsml.message.Message;
import org.auvsim.auvsml.message.command.WorldCommand;
import org.auvsim.auvsml.message.command.WorldControl;

import java.util.Optional;

/** Asks what acts on a world object. */
public record GetEffectListRequest(long worldObjectId) implements WorldCommand {
    @Override
    public Optional<Message> execute(WorldControl world) {
        return Optional.of(new EffectListResponse(worldObjectId, world.effects(worldObjectId)));
    }
}
