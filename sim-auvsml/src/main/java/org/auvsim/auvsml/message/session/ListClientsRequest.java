package org.auvsim.auvsml.message.session;

import org.auvsim.auvsml.message.Message;
import org.auvsim.auvsml.message.command.SimulatorQuery;
import org.auvsim.auvsml.message.command.SimulatorView;

import java.util.Optional;

/** Asks who is connected, and who controls what. */
public record ListClientsRequest() implements SimulatorQuery {
    @Override
    public Optional<Message> execute(SimulatorView simulator) {
        return Optional.of(new ClientListResponse(simulator.clients()));
    }
}
