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
 * Sets a force that acts at a world object's origin, without torque, until it is removed; one of
 * the same name is replaced (thesis, appendix A.2).
 *
 * @param orientation the axes of the vector
 */
public record ApplyDirectForceCommand(
        long worldObjectId, String name, Frame orientation, @Unit("N") Vec3 forceVector)
        implements WorldObjectCommand {
    @Override
    public Optional<Message> execute(WorldObjectControl object) {
        object.apply(NamedForce.direct(name, orientation, forceVector));
        return Optional.empty();
    }
}
