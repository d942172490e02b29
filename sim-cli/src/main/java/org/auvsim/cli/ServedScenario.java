package org.auvsim.cli;

import org.auvsim.auvsml.document.FeedbackTimestepping;
import org.auvsim.auvsml.document.Scenario;
import org.auvsim.auvsml.message.command.RefusedException;
import org.auvsim.cli.report.UserError;
import org.auvsim.server.feedback.AsynchronousFeedbackTimestepper;
import org.auvsim.server.feedback.AwaitedClient;
import org.auvsim.server.feedback.FeedbackProcessor;
import org.auvsim.server.feedback.FeedbackProcessors;
import org.auvsim.server.feedback.FeedbackTimestepper;
import org.auvsim.server.feedback.NoFeedbackTimestepper;
import org.auvsim.server.feedback.SimpleFixedTimeFeedbackTimestepper;
import org.auvsim.server.simulator.Simulator;
import org.auvsim.server.simulator.SimulatorBuilder;

import java.nio.file.Path;

/** A scenario's world and feedback settings as a simulator. */
final class ServedScenario {
    private ServedScenario() {}

    /**
     * A simulator that is yet to be started.
     *
     * @throws UserError if the scenario asks for something that the simulator does not have
     */
    static SimulatorBuilder simulator(Scenario scenario, Path file) {
        SimulatorBuilder simulator =
                Simulator.of(scenario.world())
                        .timestepper(timestepper(scenario.feedbackTimestepping(), file));
        scenario.feedbackProcessor()
                .ifPresent(c -> simulator.overrideProcessors(processor(c.override(), file)));
        return simulator;
    }

    private static FeedbackTimestepper timestepper(FeedbackTimestepping asked, Path file) {
        return switch (asked) {
            case FeedbackTimestepping.NoFeedbackTimestepper _ -> new NoFeedbackTimestepper();
            case FeedbackTimestepping.AsynchronousFeedbackTimestepper _ ->
                    new AsynchronousFeedbackTimestepper();
            case FeedbackTimestepping.SimpleFixedTimeFeedbackTimestepper fixed ->
                    new SimpleFixedTimeFeedbackTimestepper(
                            fixed.waiting(),
                            fixed.client().stream().map(c -> new AwaitedClient(c.name())).toList());
            default ->
                    throw new UserError(
                            "%s: this simulator has no %s."
                                    .formatted(file, asked.getClass().getSimpleName()));
        };
    }

    private static FeedbackProcessor processor(String name, Path file) {
        try {
            return FeedbackProcessors.standard().named(name);
        } catch (RefusedException e) {
            throw new UserError("%s: %s.".formatted(file, e.getMessage()), e);
        }
    }
}
