package org.auvsim.auvsml.message.control;

import org.auvsim.auvsml.document.Scenario;
import org.auvsim.auvsml.message.Message;
import org.auvsim.auvsml.message.command.SimulatorCommand;
import org.auvsim.auvsml.message.command.SimulatorControl;

import java.util.Optional;

/**
 * Goes on with another scenario, whose world and feedback take the place of what is there; every
 * client gets a {@link SnapshotRestoredNotification}. The rate, and whether time goes on, stay.
 *
 * @param scenario as a file would state it
 */
public record LoadScenarioCommand(Scenario scenario) implements SimulatorCommand {
    @Override
    public boolean actsBetweenSteps() {
        return true;
    }

    @Override
    public Optional<Message> execute(SimulatorControl simulator) {
        simulator.load(scenario);
        return Optional.empty();
    }
}
