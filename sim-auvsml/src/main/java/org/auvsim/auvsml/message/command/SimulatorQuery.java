package org.auvsim.auvsml.message.command;

import org.auvsim.auvsml.Role;

/** A question to the simulator; it changes nothing. */
public non-sealed interface SimulatorQuery extends Command<SimulatorView> {
    @Override
    default Role role() {
        return Role.VIEWER;
    }

    @Override
    default boolean actsBetweenSteps() {
        return false;
    }
}
