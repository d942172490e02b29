package org.auvsim.auvsml.message.control;

import org.auvsim.auvsml.message.Message;
import org.auvsim.auvsml.message.command.WorldObjectCommand;
import org.auvsim.auvsml.message.command.WorldObjectControl;
import org.auvsim.core.description.Unit;

import java.util.Optional;

/**
 * Turns a fin of a world object about its span, with the rate that the fin allows.
 *
 * @param name of the fin
 * @param angle within what the fin allows (rad)
 */
public record SetControlSurfaceCommand(long worldObjectId, String name, @Unit("rad") double angle)
        implements WorldObjectCommand {
    /**
     * A checked command.
     *
     * @throws IllegalArgumentException if the angle is not finite
     */
    public SetControlSurfaceCommand {
        if (!Double.isFinite(angle)) {
            throw new IllegalArgumentException("angle must be finite, but is " + angle + " rad");
        }
    }

    @Override
    public Optional<Message> execute(WorldObjectControl object) {
        object.setControlSurface(name, angle);
        return Optional.empty();
    }
}
