package org.auvsim.auvsml.message.command;

import org.auvsim.auvsml.Role;

/** A change of what is in the world. */
public non-sealed interface WorldCommand extends Command<WorldControl> {
    @Override
    default Role role() {
        return Role.ADMIN;
    }

    @Override
    default boolean actsBetweenSteps() {
        return true;
    }
}
