package org.auvsim.auvsml.message.control;

import org.auvsim.auvsml.message.Message;
import org.auvsim.auvsml.message.command.SimulatorCommand;
import org.auvsim.auvsml.message.command.SimulatorControl;

import java.util.Optional;

/** Lets the simulation stand still after the step that is under way (thesis, appendix A.1). */
public record PauseSimulatorCommand() implements SimulatorCommand {
    @Override
    public Optional<Message> execute(SimulatorControl simulator) {
        simulator.pause();
        return Optional.empty();
    }
}
