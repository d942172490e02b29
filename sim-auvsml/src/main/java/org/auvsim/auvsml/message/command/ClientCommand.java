package org.auvsim.auvsml.message.command;

import org.auvsim.auvsml.Role;

/** A command about the session of the client that sent it. */
public non-sealed interface ClientCommand extends Command<SessionControl> {
    @Override
    default Role role() {
        return Role.VIEWER;
    }

    @Override
    default boolean actsBetweenSteps() {
        return false;
    }
}
