package org.auvsim.auvsml.message.entity;

import org.auvsim.auvsml.message.Message;
import org.auvsim.auvsml.message.WorldObjectMessage;
import org.auvsim.auvsml.message.command.WorldCommand;
import org.auvsim.auvsml.message.command.WorldControl;
import org.auvsim.core.entity.Effect;

import java.util.Optional;

/**
 * Ends an effect on a world object.
 *
 * @param effect as the {@link EffectListResponse} states it; of equal ones the first ends
 */
public record RemoveEffectCommand(long worldObjectId, Effect effect)
        implements WorldCommand, WorldObjectMessage {
    @Override
    public Optional<Message> execute(WorldControl world) {
        world.removeEffect(worldObjectId, effect);
        return Optional.empty();
    }
}
