package org.auvsim.server;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.auvsim.auvsml.document.FeedbackProcessorChoice;
import org.auvsim.auvsml.document.FeedbackTimestepping;
import org.auvsim.auvsml.document.Scenario;
import org.auvsim.auvsml.document.TimeStep;
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
    private static Scenario scenario(FeedbackTimestepping stepping, Optional<String> override) {
        return new Scenario(
                0,
                false,
                false,
                0,
                new TimeStep(0.05),
                SnapshotStepper.standard(),
                stepping,
                override.map(FeedbackProcessorChoice::new),
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
                                        Optional.of("VectorAdjustmentFeedbackHandler"))))
                .contains("ACTUAL");
    }

    @Test
    void anUnknownProcessorIsOneSentence() {
        SimulatorBuilder builder =
                Simulator.of(
                        scenario(
                                new FeedbackTimestepping.AsynchronousFeedbackTimestepper(),
                                Optional.of("Magic")));
        assertThatThrownBy(builder::start)
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageStartingWith("no feedback processor has the name 'Magic'; there are");
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
