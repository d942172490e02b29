package org.auvsim.auvsml.message.lockstep;

import org.auvsim.auvsml.Role;
import org.auvsim.auvsml.message.Message;
import org.auvsim.auvsml.message.command.ClientCommand;
import org.auvsim.auvsml.message.command.SessionControl;

import java.util.Optional;

/**
 * The answer of a member in lock-step: it has sent all that it has to say to a step.
 *
 * @param step the step's number; each projected step has the next one
 */
public record ReadyCommand(long step) implements ClientCommand {
    @Override
    public Role role() {
        return Role.CONTROLLER;
    }

    @Override
    public Optional<Message> execute(SessionControl session) {
        session.ready(step);
        return Optional.empty();
    }
}
