package org.auvsim.auvsml.message.command;

import org.auvsim.auvsml.Role;

/** A question to the world; it changes nothing. */
public non-sealed interface WorldQuery extends Command<WorldView> {
    @Override
    default Role role() {
        return Role.VIEWER;
    }

    @Override
    default boolean actsBetweenSteps() {
        return false;
    }
}
