package org.auvsim.auvsml.message.command;

/**
 * A command that acts on one world object; its sender must control that object or takes control.
 */
public non-sealed interface WorldObjectCommand extends Command<WorldObjectControl> {
    /** The id of the world object that it acts on. */
    long worldObjectId();

    @Override
    default Role role() {
        return Role.CONTROLLER;
    }
}
