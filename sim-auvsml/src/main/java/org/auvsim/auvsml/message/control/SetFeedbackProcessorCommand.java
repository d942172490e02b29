package org.auvsim.auvsml.message.control;

import org.auvsim.auvsml.message.Message;
import org.auvsim.auvsml.message.command.SimulatorCommand;
import org.auvsim.auvsml.message.command.SimulatorControl;

import java.util.Optional;

/**
 * Lets one feedback processor do all corrections.
 *
 * @param override its name; left out: each message names its own again
 */
public record SetFeedbackProcessorCommand(Optional<String> override) implements SimulatorCommand {
    @Override
    public boolean actsBetweenSteps() {
        return true;
    }

    @Override
    public Optional<Message> execute(SimulatorControl simulator) {
        simulator.setFeedbackProcessor(override);
        return Optional.empty();
    }
}
