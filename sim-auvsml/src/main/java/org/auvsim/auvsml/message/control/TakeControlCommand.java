package org.auvsim.auvsml.message.control;

import org.auvsim.auvsml.Role;
import org.auvsim.auvsml.message.Message;
import org.auvsim.auvsml.message.WorldObjectMessage;
import org.auvsim.auvsml.message.command.ClientCommand;
import org.auvsim.auvsml.message.command.SessionControl;

import java.util.Optional;

/** Makes the sender the one client that may move a world object. */
public record TakeControlCommand(long worldObjectId) implements ClientCommand, WorldObjectMessage {
    @Override
    public Role role() {
        return Role.CONTROLLER;
    }

    @Override
    public boolean actsBetweenSteps() {
        return true;
    }

    @Override
    public Optional<Message> execute(SessionControl session) {
        session.takeControl(worldObjectId);
        return Optional.empty();
    }
}
