package org.auvsim.server.simulator;

import org.auvsim.auvsml.message.command.SimulatorState;

import java.util.OptionalDouble;

/** What recorded commands on time reach: the recording itself knows when steps follow. */
record ReplayControl(SimulationReplay replay) implements TimeControl {
    @Override
    public void pause() {
        // the next step follows where it was recorded
    }

    @Override
    public void resume() {
        // as with pause
    }

    @Override
    public void shutdown() {
        // the recording ends here
    }

    @Override
    public void setRate(OptionalDouble factor) {
        // the viewers' rate counts
    }

    @Override
    public void step(int count) {
        // as with pause
    }

    @Override
    public SimulatorState state() {
        return replay.state();
    }

    @Override
    public void timeHasJumped() {
        replay.timeHasJumped();
    }
}
