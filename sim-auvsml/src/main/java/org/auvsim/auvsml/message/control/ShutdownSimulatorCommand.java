package org.auvsim.auvsml.message.control;

import org.auvsim.auvsml.message.Message;
import org.auvsim.auvsml.message.command.SimulatorCommand;
import org.auvsim.auvsml.message.command.SimulatorControl;

import java.util.Optional;

/** Ends the simulation and all sessions (thesis, appendix A.1). */
public record ShutdownSimulatorCommand() implements SimulatorCommand {
    @Override
    public Optional<Message> execute(SimulatorControl simulator) {
        simulator.shutdown();
        return Optional.empty();
    }
}
