package org.auvsim.auvsml.message.control;

import org.auvsim.auvsml.message.Message;
import org.auvsim.auvsml.message.command.SimulatorCommand;
import org.auvsim.auvsml.message.command.SimulatorControl;

import java.util.Optional;

/** Asks how the simulator stands. */
public record GetSimulatorStateRequest() implements SimulatorCommand {
    @Override
    public Optional<Message> execute(SimulatorControl simulator) {
        return Optional.of(SimulatorStateResponse.of(simulator.state()));
    }
}
