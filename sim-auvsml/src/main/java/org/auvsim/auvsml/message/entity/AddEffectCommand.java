package org.auvsim.auvsml.message.entity;

import org.auvsim.auvsml.message.Message;
import org.auvsim.auvsml.message.WorldObjectMessage;
import org.auvsim.auvsml.message.command.WorldCommand;
import org.auvsim.auvsml.message.command.WorldControl;
import org.auvsim.core.entity.Effect;

import java.util.Optional;

/** Lets an effect, described as in a scenario, act on a world object from now on. */
public record AddEffectCommand(long worldObjectId, Effect effect)
        implements WorldCommand, WorldObjectMessage {
    @Override
    public Optional<Message> execute(WorldControl world) {
        world.addEffect(worldObjectId, effect);
        return Optional.empty();
    }
}
