package org.auvsim.auvsml.message.control;

import org.auvsim.auvsml.message.Message;
import org.auvsim.auvsml.message.command.SimulatorQuery;
import org.auvsim.auvsml.message.command.SimulatorView;

import java.util.Optional;

/** Asks how the simulator stands. */
public record GetSimulatorStateRequest() implements SimulatorQuery {
    @Override
    public Optional<Message> execute(SimulatorView simulator) {
        return Optional.of(SimulatorStateResponse.of(simulator.state()));
    }
}
