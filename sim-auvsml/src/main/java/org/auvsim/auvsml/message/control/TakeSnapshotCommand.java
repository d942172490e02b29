package org.auvsim.auvsml.message.control;

import org.auvsim.auvsml.message.Message;
import org.auvsim.auvsml.message.OneLine;
import org.auvsim.auvsml.message.command.SimulatorCommand;
import org.auvsim.auvsml.message.command.SimulatorControl;

import java.util.Optional;

/**
 * Keeps the world, and who controls what, as they are now, under a name; a snapshot of the same
 * name is replaced.
 */
public record TakeSnapshotCommand(String name) implements SimulatorCommand {
    /**
     * A checked command.
     *
     * @throws IllegalArgumentException if the name is blank or not one line
     */
    public TakeSnapshotCommand {
        OneLine.of("a snapshot's name", name);
        if (name.isBlank()) {
            throw new IllegalArgumentException("a snapshot needs a name that is not blank");
        }
    }

    @Override
    public boolean actsBetweenSteps() {
        return true;
    }

    @Override
    public Optional<Message> execute(SimulatorControl simulator) {
        simulator.takeSnapshot(name);
        return Optional.empty();
    }
}
