package org.auvsim.auvsml.message.control;

import org.auvsim.auvsml.document.FeedbackTimestepping;
import org.auvsim.auvsml.message.Message;
import org.auvsim.auvsml.message.command.SimulatorCommand;
import org.auvsim.auvsml.message.command.SimulatorControl;

import java.util.Optional;

/**
 * Makes steps, and takes feedback, in another way from the next step on.
 *
 * @param feedbackTimestepping as a scenario states it
 */
public record SetTimestepperCommand(FeedbackTimestepping feedbackTimestepping)
        implements SimulatorCommand {
    @Override
    public boolean actsBetweenSteps() {
        return true;
    }

    @Override
    public Optional<Message> execute(SimulatorControl simulator) {
        simulator.setTimestepper(feedbackTimestepping);
        return Optional.empty();
    }
}
