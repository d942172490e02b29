package org.auvsim.server.simulator;

import org.auvsim.auvsml.document.FeedbackTimestepping;
import org.auvsim.auvsml.document.Scenario;
import org.auvsim.auvsml.message.command.KeptSnapshot;
import org.auvsim.auvsml.message.command.ListedClient;
import org.auvsim.auvsml.message.command.SimulatorControl;
import org.auvsim.auvsml.message.command.SimulatorState;
import org.auvsim.auvsml.message.learning.ModelCorrection;

import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;

/** The simulator as commands reach it: time is the clock's, everything else the simulation's. */
record SimulatorPort(Simulation simulation, TimeControl time) implements SimulatorControl {
    @Override
    public void pause() {
        time.pause();
    }

    @Override
    public void resume() {
        time.resume();
    }

    @Override
    public void shutdown() {
        time.shutdown();
    }

    @Override
    public void setRate(OptionalDouble factor) {
        time.setRate(factor);
    }

    @Override
    public void step(int count) {
        time.step(count);
    }

    @Override
    public SimulatorState state() {
        return time.state();
    }

    @Override
    public void setTimestepper(FeedbackTimestepping choice) {
        simulation.setTimestepper(choice);
    }

    @Override
    public void setFeedbackProcessor(Optional<String> name) {
        simulation.setFeedbackProcessor(name);
    }

    @Override
    public List<KeptSnapshot> snapshots() {
        return simulation.snapshots().list();
    }

    @Override
    public void takeSnapshot(String name) {
        simulation.takeSnapshot(name);
    }

    @Override
    public void restoreSnapshot(String name) {
        simulation.restoreSnapshot(name);
        time.timeHasJumped();
    }

    @Override
    public void reset() {
        simulation.reset();
        time.timeHasJumped();
    }

    @Override
    public void load(Scenario scenario) {
        simulation.load(scenario);
        time.timeHasJumped();
    }

    @Override
    public void announce(long worldObjectId, ModelCorrection correction) {
        simulation.announce(worldObjectId, correction);
    }

    @Override
    public List<ListedClient> clients() {
        return simulation.clients().list();
    }

    @Override
    public void disconnect(String client, String reason) {
        simulation.disconnect(simulation.clients().named(client), reason);
    }
}
