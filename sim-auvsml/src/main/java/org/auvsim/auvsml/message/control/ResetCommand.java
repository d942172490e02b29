package org.auvsim.auvsml.message.control;

import org.auvsim.auvsml.message.Message;
import org.auvsim.auvsml.message.command.SimulatorCommand;
import org.auvsim.auvsml.message.command.SimulatorControl;

import java.util.Optional;

/**
 * Begins again, as the simulation began; every client gets a {@link SnapshotRestoredNotification}.
 */
public record ResetCommand() implements SimulatorCommand {
    @Override
    public boolean actsBetweenSteps() {
        return true;
    }

    @Override
    public Optional<Message> execute(SimulatorControl simulator) {
        simulator.reset();
        return Optional.empty();
    }
}
