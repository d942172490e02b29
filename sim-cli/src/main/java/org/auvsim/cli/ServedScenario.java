package org.auvsim.cli;

import org.auvsim.auvsml.document.FeedbackProcessorChoice;
import org.auvsim.auvsml.document.Scenario;
import org.auvsim.auvsml.message.command.RefusedException;
import org.auvsim.cli.report.UserError;
import org.auvsim.core.step.Lanes;
import org.auvsim.server.feedback.FeedbackProcessors;
import org.auvsim.server.simulator.Simulator;
import org.auvsim.server.simulator.SimulatorBuilder;

import java.nio.file.Path;

/** A scenario's world and feedback settings as a simulator. */
final class ServedScenario {
    private ServedScenario() {}

    /**
     * A simulator that is yet to be started; its steps are made on {@code lanes}.
     *
     * @throws UserError if the scenario asks for something that the simulator does not have
     */
    static SimulatorBuilder simulator(Scenario scenario, Lanes lanes, Path file) {
        scenario.feedbackProcessor()
                .flatMap(FeedbackProcessorChoice::override)
                .ifPresent(name -> requireProcessor(name, file));
        try {
            return Simulator.of(scenario, lanes);
        } catch (IllegalArgumentException e) {
            throw new UserError("%s: %s.".formatted(file, e.getMessage()), e);
        }
    }

    private static void requireProcessor(String name, Path file) {
        try {
            FeedbackProcessors.standard().named(name);
        } catch (RefusedException e) {
            throw new UserError("%s: %s.".formatted(file, e.getMessage()), e);
        }
    }
}
