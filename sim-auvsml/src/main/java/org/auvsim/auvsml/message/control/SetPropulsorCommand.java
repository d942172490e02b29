package org.auvsim.auvsml.message.control;

import org.auvsim.auvsml.message.Message;
import org.auvsim.auvsml.message.command.WorldObjectCommand;
import org.auvsim.auvsml.message.command.WorldObjectControl;

import java.util.Optional;

/**
 * Sets how hard a propulsor of a world object pushes.
 *
 * @param level -1 (full astern) to 1 (full ahead)
 */
public record SetPropulsorCommand(long worldObjectId, String name, double level)
        implements WorldObjectCommand {
    /**
     * A checked command.
     *
     * @throws IllegalArgumentException if the level is outside [-1, 1]
     */
    public SetPropulsorCommand {
        if (!(level >= -1 && level <= 1)) {
            throw new IllegalArgumentException("level must be -1 to 1, but is " + level);
        }
    }

    @Override
    public Optional<Message> execute(WorldObjectControl object) {
        object.setPropulsorLevel(name, level);
        return Optional.empty();
    }
}
