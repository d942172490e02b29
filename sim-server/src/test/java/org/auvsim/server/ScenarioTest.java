package org.auvsim.server;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import org.auvsim.auvsml.document.Deviations;
import org.auvsim.auvsml.document.FeedbackProcessing;
import org.auvsim.auvsml.document.FeedbackProcessorChoice;
import org.auvsim.auvsml.document.FeedbackTimestepping;
import org.auvsim.auvsml.document.FeedbackTimestepping.AwaitedClient;
import org.auvsim.auvsml.document.MomentumRule;
import org.auvsim.auvsml.document.Scenario;
import org.auvsim.auvsml.document.TimeStep;
import org.auvsim.core.dynamics.Rk4;
import org.auvsim.core.step.SnapshotStepper;
import org.auvsim.server.net.TcpTransport;
import org.auvsim.server.simulator.Simulator;
import org.auvsim.server.simulator.SimulatorBuilder;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

import java.io.IOException;
import java.util.List;
import java.util.Optional;

/** A scenario says how its world is served. */
@Timeout(60)
class ScenarioTest {
    private static Scenario scenario(
            FeedbackTimestepping stepping, Optional<FeedbackProcessorChoice> choice) {
        return new Scenario(
                0,
                false,
                false,
                0,
                new TimeStep(0.05),
                SnapshotStepper.standard(),
                new Rk4(),
                stepping,
                choice,
                Optional.empty(),
                Optional.empty(),
                List.of(),
                List.of(Tank.ball(1, "ship", 0, 0, 0)));
    }

    private static String firstStep(Scenario scenario) throws IOException {
        TcpTransport tcp = TcpTransport.onLoopback(0);
        try (Simulator _ = Simulator.of(scenario).paused().transport(tcp).start();
                RawClient client = RawClient.welcomed(tcp.port())) {
            client.ask(
                    "r",
                    "<listener-registration-request-command register=\"1\"><world-object id=\"1\">"
                            + "<listener type=\"TimestepAdvanced\"/></world-object>"
                            + "</listener-registration-request-command>");
            client.send("<auvsml><step-command/></auvsml>");
            return client.next();
        }
    }

    @Test
    void itsFeedbackTimestepperIsUsed() throws IOException {
        assertThat(
                        firstStep(
                                scenario(
                                        new FeedbackTimestepping.SimpleFixedTimeFeedbackTimestepper(
                                                0.001, List.of()),
                                        Optional.empty())))
                .contains("PROJECTED");
        assertThat(
                        firstStep(
                                scenario(
                                        new FeedbackTimestepping.NoFeedbackTimestepper(),
                                        Optional.empty())))
                .contains("ACTUAL");
        assertThat(
                        firstStep(
                                scenario(
                                        new FeedbackTimestepping.AsynchronousFeedbackTimestepper(),
                                        Optional.of(
                                                new FeedbackProcessorChoice(
                                                        "VectorAdjustmentFeedbackHandler")))))
                .contains("ACTUAL");
    }

    @Test
    void anUnknownProcessorIsOneSentence() {
        SimulatorBuilder builder =
                Simulator.of(
                        scenario(
                                new FeedbackTimestepping.AsynchronousFeedbackTimestepper(),
                                Optional.of(new FeedbackProcessorChoice("Magic"))));
        assertThatThrownBy(builder::start)
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageStartingWith("no feedback processor has the name 'Magic'; there are");
    }

    /** One force for the whole step leaves the velocity that the thesis' does: 2 d / dt. */
    @Test
    void aProcessorWorksAsTheScenarioStates() throws IOException {
        FeedbackProcessorChoice choice =
                new FeedbackProcessorChoice(
                        Optional.of("VectorAdjustmentFeedbackHandler"),
                        List.of(
                                new FeedbackProcessing.VectorAdjustmentFeedbackHandler(
                                        MomentumRule.AS_THESIS),
                                new FeedbackProcessing.KalmanFilterFeedbackHandler(
                                        0.1,
                                        0.1,
                                        new Deviations(1, 1, 1, 1),
                                        new Deviations(1, 1, 1, 1))));
        assertThat(velocityAfterFeedback(choice)).isCloseTo(2 * 0.1 / 0.05, within(1e-6));
        FeedbackProcessorChoice plain =
                new FeedbackProcessorChoice("VectorAdjustmentFeedbackHandler");
        assertThat(velocityAfterFeedback(plain)).isCloseTo(0, within(1e-6));
    }

    /** Of an object at rest that was measured 0.1 m beside, at the end of the step. */
    private static double velocityAfterFeedback(FeedbackProcessorChoice choice) throws IOException {
        TcpTransport tcp = TcpTransport.onLoopback(0);
        try (Simulator simulator =
                        Simulator.of(
                                        scenario(
                                                new FeedbackTimestepping
                                                        .SimpleFixedTimeFeedbackTimestepper(
                                                        60, List.of(new AwaitedClient("client 1"))),
                                                Optional.of(choice)))
                                .paused()
                                .transport(tcp)
                                .start();
                RawClient client = RawClient.welcomed(tcp.port())) {
            client.ask(
                    "r",
                    "<listener-registration-request-command register=\"1\"><world-object id=\"1\">"
                            + "<listener type=\"*ALL*\"/></world-object>"
                            + "</listener-registration-request-command>");
            client.send("<auvsml><step-command/></auvsml>");
            client.next("timestep-advanced-notification");
            client.send(
                    "<auvsml><different-state-feedback-message world-object-id=\"1\""
                            + " timestamp=\"0.05\" handler-name=\"IgnoreFeedbackHandler\"><position"
                            + " x=\"0.0\" y=\"0.1\" z=\"0.0\"/></different-state-feedback-message>"
                            + "</auvsml>");
            client.next("feedback-applied-notification");
            return simulator.ask(world -> world.object(1).velocity().y());
        }
    }

    /** Says how feedback is used, and is not made for this server. */
    private record ForeignProcessing() implements FeedbackProcessing {}

    @Test
    void aForeignProcessorIsOneSentence() {
        Scenario foreign =
                scenario(
                        new FeedbackTimestepping.AsynchronousFeedbackTimestepper(),
                        Optional.of(
                                new FeedbackProcessorChoice(
                                        Optional.empty(), List.of(new ForeignProcessing()))));
        assertThatThrownBy(() -> Simulator.of(foreign))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("ForeignProcessing is no feedback processor of this server");
    }

    /** Says how steps are made, and is not made for this server. */
    private record Foreign() implements FeedbackTimestepping {}

    @Test
    void aForeignTimestepperIsOneSentence() {
        Scenario foreign = scenario(new Foreign(), Optional.empty());
        assertThatThrownBy(() -> Simulator.of(foreign))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("Foreign is no time-stepper of this server");
    }
}
