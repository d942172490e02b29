package org.auvsim.auvsml.message.entity;

import org.auvsim.auvsml.message.Message;
import org.auvsim.auvsml.message.command.WorldCommand;
import org.auvsim.auvsml.message.command.WorldControl;
import org.auvsim.core.entity.WorldObjectDefinition;

import java.util.Optional;

/**
 * Gives the world object of this name, while it moves, other mass properties, effects and
 * components, described as in a scenario. Its id, its motion, the forces on it and what its
 * actuators are told stay as they are, whatever is stated of them.
 */
public record ReviseWorldObjectCommand(WorldObjectDefinition worldObject) implements WorldCommand {
    @Override
    public Optional<Message> execute(WorldControl world) {
        world.revise(worldObject);
        return Optional.empty();
    }
}
