package org.auvsim.auvsml.message.control;

import org.auvsim.auvsml.message.Message;
import org.auvsim.auvsml.message.command.WorldObjectCommand;
import org.auvsim.auvsml.message.command.WorldObjectControl;
import org.auvsim.core.description.Unit;
import org.auvsim.core.entity.Frame;
import org.auvsim.core.entity.NamedForce;
import org.auvsim.core.math.Vec3;

import java.util.Optional;

/**
 * Sets a force that acts at a point of a world object, and so may turn it, until it is removed; one
 * of the same name is replaced.
 *
 * @param orientation the axes of the vector
 * @param point in body coordinates whatever the orientation; refused outside the object's volume
 */
public record ApplyForceCommand(
        long worldObjectId,
        String name,
        Frame orientation,
        @Unit("N") Vec3 forceVector,
        @Unit("m") Vec3 point)
        implements WorldObjectCommand {
    @Override
    public Optional<Message> execute(WorldObjectControl object) {
        object.apply(new NamedForce(name, orientation, forceVector, point));
        return Optional.empty();
    }
}
