package org.auvsim.auvsml.message.command;

import org.auvsim.auvsml.Role;
import org.auvsim.auvsml.message.WorldObjectMessage;

/**
 * A command that acts on one world object; its sender must control that object or takes control.
 */
public non-sealed interface WorldObjectCommand
        extends Command<WorldObjectControl>, WorldObjectMessage {
    @Override
    default Role role() {
        return Role.CONTROLLER;
    }

    @Override
    default boolean actsBetweenSteps() {
        return true;
    }
}
