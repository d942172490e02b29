package org.auvsim.cli.demo;

import org.auvsim.auvsml.document.Scenario;
import org.auvsim.auvsml.message.learning.ModelCorrectionNotification;
import org.auvsim.diagnosis.online.Corrector;
import org.auvsim.diagnosis.online.LearningFeedbackHandler;
import org.auvsim.server.net.TransportException;
import org.auvsim.server.simulator.Simulator;

import java.io.IOException;
import java.util.Optional;

/**
 * The robot flies round after round while the server learns from its feedback what the model lacks,
 * and one round more with what was learned.
 */
final class LearningFlight {
    /** If nothing was learned by then, nothing will be. */
    private static final int MOST_ROUNDS = 40;

    private static final int READ_EVERY = 4;
    private static final int KEEP = 6000;

    private final Scenario scenario;
    private final Track track;
    private final LiveTable table;

    LearningFlight(Scenario scenario, Track track, LiveTable table) {
        this.scenario = scenario;
        this.track = track;
        this.table = table;
    }

    /** Flies; returns what was learned, if anything was. */
    Optional<ModelCorrectionNotification> fly() throws IOException, TransportException {
        LearningFeedbackHandler learner =
                new LearningFeedbackHandler(
                        Corrector.KALMAN_FILTER,
                        /* extendsWorld= */ true,
                        FlightPlan.DURATION - 1,
                        KEEP,
                        Demonstration.SEED);
        return new Flight(
                        Simulator.of(scenario).processor(learner),
                        new FlightPlan(MOST_ROUNDS + 1),
                        Optional.of(new Sensors("LearningFeedbackHandler", READ_EVERY, true)),
                        track,
                        table)
                .fly(LearningFlight::end)
                .learned();
    }

    private static double end(PhysicalRobot robot) {
        return robot.learned()
                .map(found -> found.timestamp() + FlightPlan.DURATION)
                .orElse(MOST_ROUNDS * FlightPlan.DURATION);
    }
}
