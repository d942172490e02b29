package org.auvsim.auvsml.message.entity;

import org.auvsim.auvsml.message.Message;
import org.auvsim.auvsml.message.command.WorldCommand;
import org.auvsim.auvsml.message.command.WorldControl;
import org.auvsim.core.entity.Field;

import java.util.Optional;

/**
 * Adds a field, a current for example, described as in a scenario; {@link RemoveEntityCommand}
 * takes it away.
 */
public record AddFieldCommand(Field<?> field) implements WorldCommand {
    @Override
    public Optional<Message> execute(WorldControl world) {
        world.add(field);
        return Optional.empty();
    }
}
