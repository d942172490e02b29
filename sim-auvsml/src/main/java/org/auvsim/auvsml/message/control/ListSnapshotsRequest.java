package org.auvsim.auvsml.message.control;

import org.auvsim.auvsml.message.Message;
import org.auvsim.auvsml.message.command.SimulatorQuery;
import org.auvsim.auvsml.message.command.SimulatorView;

import java.util.Optional;

/** Asks which snapshots the simulator keeps. */
public record ListSnapshotsRequest() implements SimulatorQuery {
    @Override
    public Optional<Message> execute(SimulatorView simulator) {
        return Optional.of(new SnapshotListResponse(simulator.snapshots()));
    }
}
