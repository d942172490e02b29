package org.auvsim.auvsml.message.control;

import org.auvsim.auvsml.message.Message;
import org.auvsim.auvsml.message.OneLine;
import org.auvsim.auvsml.message.command.SimulatorCommand;
import org.auvsim.auvsml.message.command.SimulatorControl;

import java.util.Optional;

/**
 * Goes back to a snapshot: the world's time is then that of the snapshot, and every client gets a
 * {@link SnapshotRestoredNotification}.
 */
public record RestoreSnapshotCommand(String name) implements SimulatorCommand {
    /**
     * A checked command.
     *
     * @throws IllegalArgumentException if the name is not one line
     */
    public RestoreSnapshotCommand {
        OneLine.of("a snapshot's name", name);
    }

    @Override
    public boolean actsBetweenSteps() {
        return true;
    }

    @Override
    public Optional<Message> execute(SimulatorControl simulator) {
        simulator.restoreSnapshot(name);
        return Optional.empty();
    }
}
