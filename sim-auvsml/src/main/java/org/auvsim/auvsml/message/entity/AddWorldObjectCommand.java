package org.auvsim.auvsml.message.entity;

import org.auvsim.auvsml.message.Message;
import org.auvsim.auvsml.message.command.WorldCommand;
import org.auvsim.auvsml.message.command.WorldControl;
import org.auvsim.core.entity.WorldObjectDefinition;

import java.util.Optional;

/** Adds a world object, described as in a scenario; its id comes back. */
public record AddWorldObjectCommand(WorldObjectDefinition worldObject) implements WorldCommand {
    @Override
    public Optional<Message> execute(WorldControl world) {
        return Optional.of(new AddWorldObjectResponse(world.add(worldObject)));
    }
}
