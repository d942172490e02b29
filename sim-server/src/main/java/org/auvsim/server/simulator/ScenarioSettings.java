package org.auvsim.server.simulator;

import org.auvsim.auvsml.document.FeedbackProcessorChoice;
import org.auvsim.auvsml.document.FeedbackTimestepping;
import org.auvsim.auvsml.document.FeedbackTimestepping.AwaitedClient;
import org.auvsim.auvsml.document.Scenario;
import org.auvsim.core.step.Lanes;
import org.auvsim.server.feedback.AsynchronousFeedbackTimestepper;
import org.auvsim.server.feedback.FeedbackProcessor;
import org.auvsim.server.feedback.FeedbackProcessors;
import org.auvsim.server.feedback.FeedbackTimestepper;
import org.auvsim.server.feedback.LockstepTimestepper;
import org.auvsim.server.feedback.NoFeedbackTimestepper;
import org.auvsim.server.feedback.SimpleFixedTimeFeedbackTimestepper;

import java.time.Duration;
import java.util.List;

/** What a scenario says of how its world is to be served. */
final class ScenarioSettings {
    private ScenarioSettings() {}

    static SimulatorBuilder builder(Scenario scenario, Lanes lanes) {
        SimulatorBuilder builder =
                new SimulatorBuilder(scenario.world(lanes))
                        .timestepper(timestepper(scenario.feedbackTimestepping()))
                        .feedbackHorizon(scenario.feedbackHorizon());
        scenario.releasedObject().ifPresent(builder::releasedObject);
        scenario.feedbackProcessor().ifPresent(builder::processors);
        return builder;
    }

    /**
     * The processors that a scenario states.
     *
     * @throws IllegalArgumentException if one is none of a server
     */
    static List<FeedbackProcessor> processors(FeedbackProcessorChoice choice) {
        return choice.processor().stream().map(FeedbackProcessors::of).toList();
    }

    /**
     * The time-stepper that a scenario asks for.
     *
     * @throws IllegalArgumentException if it is none of a server
     */
    static FeedbackTimestepper timestepper(FeedbackTimestepping choice) {
        return switch (choice) {
            case FeedbackTimestepper own -> own;
            case FeedbackTimestepping.NoFeedbackTimestepper _ -> new NoFeedbackTimestepper();
            case FeedbackTimestepping.AsynchronousFeedbackTimestepper _ ->
                    new AsynchronousFeedbackTimestepper();
            case FeedbackTimestepping.LockstepTimestepper lockstep ->
                    new LockstepTimestepper(
                            lockstep.timeout().stream()
                                    .mapToObj(ScenarioSettings::duration)
                                    .findFirst(),
                            lockstep.then());
            case FeedbackTimestepping.SimpleFixedTimeFeedbackTimestepper simple ->
                    new SimpleFixedTimeFeedbackTimestepper(
                            duration(simple.waiting()),
                            simple.client().stream().map(AwaitedClient::name).toList());
            default ->
                    throw new IllegalArgumentException(
                            "%s is no time-stepper of this server: its record must be a %s too"
                                    .formatted(
                                            choice.getClass().getSimpleName(),
                                            FeedbackTimestepper.class.getSimpleName()));
        };
    }

    private static Duration duration(double seconds) {
        return Duration.ofNanos((long) (seconds * 1e9));
    }
}
