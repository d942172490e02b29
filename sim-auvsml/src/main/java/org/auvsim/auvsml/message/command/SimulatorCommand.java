package org.auvsim.auvsml.message.command;

import org.auvsim.auvsml.Role;

/** A command to the simulator: how time goes on. */
public non-sealed interface SimulatorCommand extends Command<SimulatorControl> {
    @Override
    default Role role() {
        return Role.ADMIN;
    }

    @Override
    default boolean actsBetweenSteps() {
        return false;
    }
}
