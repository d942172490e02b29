package org.auvsim.auvsml.message.control;

import org.auvsim.auvsml.message.Message;
import org.auvsim.auvsml.message.command.WorldObjectCommand;
import org.auvsim.auvsml.message.command.WorldObjectControl;

import java.util.Optional;

/** Removes a force by its name (thesis, appendix A.2). */
public record RemoveForceCommand(long worldObjectId, String forceName)
        implements WorldObjectCommand {
    @Override
    public Optional<Message> execute(WorldObjectControl object) {
        object.removeForce(forceName);
        return Optional.empty();
    }
}
