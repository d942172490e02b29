package org.auvsim.auvsml.message.control;

import org.auvsim.auvsml.message.Message;
import org.auvsim.auvsml.message.command.SimulatorCommand;
import org.auvsim.auvsml.message.command.SimulatorControl;
import org.auvsim.core.description.Default;

import java.util.Optional;

/**
 * Makes steps while the simulation is paused.
 *
 * @param count how many, 1 or more
 */
public record StepCommand(@Default("1") int count) implements SimulatorCommand {
    /**
     * A checked command.
     *
     * @throws IllegalArgumentException if the count is below 1
     */
    public StepCommand {
        if (count < 1) {
            throw new IllegalArgumentException("count must be 1 or more, but is " + count);
        }
    }

    @Override
    public Optional<Message> execute(SimulatorControl simulator) {
        simulator.step(count);
        return Optional.empty();
    }
}
