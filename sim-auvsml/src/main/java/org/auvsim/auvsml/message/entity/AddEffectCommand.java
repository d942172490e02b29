package org.auvsim.auvsml.message.entity;

import org.auvsim.auvsml.message.Message;
import org.auvsim.auvsml.message.command.WorldObjectCommand;
import org.auvsim.auvsml.message.command.WorldObjectControl;
import org.auvsim.core.entity.Effect;

import java.util.Optional;

/** Lets an effect, described as in a scenario, act on a world object from now on. */
public record AddEffectCommand(long worldObjectId, Effect effect) implements WorldObjectCommand {
    @Override
    public Optional<Message> execute(WorldObjectControl object) {
        object.addEffect(effect);
        return Optional.empty();
    }
}
