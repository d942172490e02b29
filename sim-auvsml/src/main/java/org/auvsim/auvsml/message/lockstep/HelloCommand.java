package org.auvsim.auvsml.message.lockstep;

import org.auvsim.auvsml.Role;
import org.auvsim.auvsml.message.Message;
import org.auvsim.auvsml.message.OneLine;
import org.auvsim.auvsml.message.command.ClientCommand;
import org.auvsim.auvsml.message.command.SessionControl;

import java.util.Optional;

/**
 * Names the client, and makes it a member of a simulation that goes on in lock-step. From the step
 * on that the response names, the simulator waits for the client's answers.
 *
 * @param name the client's name, of which there must be no other
 */
public record HelloCommand(String name) implements ClientCommand {
    /**
     * A checked name.
     *
     * @throws IllegalArgumentException if it is blank, longer than 64 characters, or not one line
     */
    public HelloCommand {
        OneLine.of("a client's name", name);
        if (name.isBlank() || name.length() > 64) {
            throw new IllegalArgumentException(
                    "a client's name must have 1 to 64 characters, but is '" + name + "'");
        }
    }

    @Override
    public Role role() {
        return Role.CONTROLLER;
    }

    @Override
    public Optional<Message> execute(SessionControl session) {
        return Optional.of(new HelloResponse(session.join(name)));
    }
}
