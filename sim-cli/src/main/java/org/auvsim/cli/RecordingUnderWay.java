package org.auvsim.cli;

import org.auvsim.auvsml.message.session.RecordingEndedNotification;
import org.auvsim.server.replay.Recorder;
import org.auvsim.server.simulator.Simulator;
import org.auvsim.server.simulator.SimulatorBuilder;

import java.util.Optional;

/** The recording of a simulation, or none. */
record RecordingUnderWay(Optional<Recorder> recorder) implements AutoCloseable {
    /** Lets the recorder hear what is to be recorded. */
    SimulatorBuilder of(SimulatorBuilder simulator) {
        return recorder.map(simulator::log).orElse(simulator);
    }

    /** Has all clients told if the recording ends before the simulation does. */
    void tellIfEnded(Simulator simulator) {
        recorder.ifPresent(
                r -> r.whenEnded(reason -> simulator.tell(new RecordingEndedNotification(reason))));
    }

    /** Why the recording is not whole, as known after it is closed; empty if it is, or is none. */
    Optional<String> failure() {
        return recorder.flatMap(Recorder::failure);
    }

    @Override
    public void close() {
        recorder.ifPresent(Recorder::close);
    }
}
