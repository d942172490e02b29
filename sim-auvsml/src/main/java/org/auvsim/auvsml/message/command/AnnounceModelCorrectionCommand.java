package org.auvsim.auvsml.message.command;

import org.auvsim.auvsml.message.Message;
import org.auvsim.auvsml.message.WorldObjectMessage;
import org.auvsim.auvsml.message.learning.ModelCorrection;

import java.util.Optional;

/**
 * Tells those who listen to {@code ModelCorrection} of a world object what was found that its model
 * lacks; it changes nothing. A learner that sits beside the simulation sends it, or one outside.
 */
public record AnnounceModelCorrectionCommand(long worldObjectId, ModelCorrection modelCorrection)
        implements SimulatorCommand, WorldObjectMessage {
    /** After what it announces, which may wait for the end of a step. */
    @Override
    public boolean actsBetweenSteps() {
        return true;
    }

    @Override
    public Optional<Message> execute(SimulatorControl simulator) {
        simulator.announce(worldObjectId, modelCorrection);
        return Optional.empty();
    }
}
