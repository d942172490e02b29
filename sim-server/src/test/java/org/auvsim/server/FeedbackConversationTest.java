package org.auvsim.server;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.auvsim.core.math.Vec3;
import org.auvsim.core.world.World;
import org.auvsim.server.feedback.AsynchronousFeedbackTimestepper;
import org.auvsim.server.feedback.SimpleFixedTimeFeedbackTimestepper;
import org.auvsim.server.net.TcpTransport;
import org.auvsim.server.simulator.Simulator;
import org.auvsim.server.simulator.SimulatorBuilder;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

import java.io.IOException;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;

/** A robot corrects the world, over a real socket. */
@Timeout(60)
class FeedbackConversationTest {
    private final TcpTransport tcp = TcpTransport.onLoopback(0);
    private Optional<Simulator> simulator = Optional.empty();
    private Optional<RawClient> robot = Optional.empty();

    /** Long enough for the test to fail if the wait does not end with the robot's answer. */
    private static SimulatorBuilder waitingForRobot(World world) {
        return Simulator.of(world)
                .timestepper(
                        new SimpleFixedTimeFeedbackTimestepper(
                                Duration.ofMinutes(2), List.of("client 1")));
    }

    private RawClient start(SimulatorBuilder builder) throws IOException {
        simulator =
                Optional.of(builder.rate(OptionalDouble.empty()).paused().transport(tcp).start());
        RawClient client = RawClient.welcomed(tcp.port());
        robot = Optional.of(client);
        client.ask(
                "r",
                "<listener-registration-request-command register=\"1\"><world-object"
                    + " id=\"1\"><listener type=\"MovementStateChange\"/><listener"
                    + " type=\"ProjectedMovement\"/><listener type=\"TimestepAdvanced\"/><listener"
                    + " type=\"FeedbackApplied\"/>"
                    + "</world-object></listener-registration-request-command>");
        client.send("<auvsml><step-command/></auvsml>");
        return client;
    }

    @BeforeEach
    void nothingIsOpen() {
        assertThat(simulator).isEmpty();
    }

    @AfterEach
    void close() throws IOException {
        if (robot.isPresent()) {
            robot.get().close();
        }
        simulator.ifPresent(Simulator::close);
    }

    private static String feedback(String timestamp, String handler, Vec3 actual) {
        return "<auvsml><different-position-feedback-message world-object-id=\"1\" timestamp=\""
                + timestamp
                + "\" handler-name=\""
                + handler
                + "\"><virtual-position x=\"0.0\" y=\"0.0\" z=\"0.0\"/><actual-position x=\""
                + actual.x()
                + "\" y=\""
                + actual.y()
                + "\" z=\""
                + actual.z()
                + "\"/><old-position x=\"0.0\" y=\"0.0\" z=\"0.0\"/>"
                + "</different-position-feedback-message></auvsml>";
    }

    @Test
    void oneStepWithDirectAlteration() throws IOException {
        RawClient client = start(waitingForRobot(Tank.world()));
        assertThat(client.next())
                .contains("movement-state-change-message timestamp=\"0.05\"")
                .contains("is-projected-state=\"1\"");
        assertThat(client.next())
                .isEqualTo(
                        "<auvsml><timestep-advanced-notification timestamp=\"0.05\""
                                + " state-type=\"PROJECTED\"/></auvsml>");
        client.send(
                feedback("0.05", "DirectPositionChangeFeedbackHandler", new Vec3(0.98, 2.1, 3.4)));
        assertThat(client.next())
                .contains("is-projected-state=\"0\"")
                .contains("x=\"0.0\" y=\"0.0\"");
        assertThat(client.next())
                .contains("timestamp=\"0.05\"")
                .contains("is-projected-state=\"0\"")
                .contains("<position x=\"0.98\" y=\"2.1\" z=\"3.4\"/>");
        String applied = client.next();
        assertThat(applied)
                .contains("handler-name=\"DirectPositionChangeFeedbackHandler\"")
                .contains("<measured-position x=\"0.98\" y=\"2.1\" z=\"3.4\"/>");
        assertThat(RawClient.number(applied, "feedback-applied", "error-before"))
                .isCloseTo(new Vec3(0.98, 2.1, 3.4).norm(), within(1e-12));
        assertThat(RawClient.number(applied, "feedback-applied", "error-after")).isZero();
        assertThat(client.next())
                .isEqualTo(
                        "<auvsml><timestep-advanced-notification timestamp=\"0.05\""
                                + " state-type=\"ACTUAL\"/></auvsml>");
    }

    @Test
    void oneStepWithVectorAdjustment() throws IOException {
        RawClient client = start(waitingForRobot(Tank.world()));
        client.next("timestep-advanced-notification");
        client.send(feedback("0.05", "VectorAdjustmentFeedbackHandler", new Vec3(0.01, 0, 0)));
        String moved = client.next();
        assertThat(moved).contains("is-projected-state=\"0\"");
        assertThat(RawClient.number(moved, "position", "x")).isCloseTo(0.01, within(1e-9));
        assertThat(RawClient.number(moved, "linear-momentum", "x")).isCloseTo(0, within(1e-6));
        String applied = client.next();
        assertThat(applied).contains("handler-name=\"VectorAdjustmentFeedbackHandler\"");
        assertThat(RawClient.number(applied, "feedback-applied", "error-after")).isLessThan(1e-9);
        assertThat(client.next()).contains("ACTUAL");
    }

    @Test
    void commandsAreHeldUntilTheStepIsOver() throws IOException {
        RawClient client = start(waitingForRobot(Tank.world()));
        client.next("timestep-advanced-notification");
        client.send(
                "<auvsml request-id=\"held\"><apply-direct-force-command world-object-id=\"1\""
                        + " name=\"f\" orientation=\"WORLD\"><force-vector x=\"4.0\" y=\"0.0\""
                        + " z=\"0.0\"/></apply-direct-force-command></auvsml>"
                        + feedback("0.05", "DirectPositionChangeFeedbackHandler", Vec3.ZERO));
        String moved = client.next();
        assertThat(moved).contains("is-projected-state=\"0\"");
        assertThat(RawClient.number(moved, "linear-momentum", "x")).isZero();
        client.next("timestep-advanced-notification");
        assertThat(client.next()).contains("request-id=\"held\"").contains("command-done-response");
    }

    @Test
    void theServersProcessorOverridesTheMessages() throws IOException {
        RawClient client =
                start(
                        waitingForRobot(Tank.world())
                                .overrideProcessors("DirectPositionChangeFeedbackHandler"));
        client.next("timestep-advanced-notification");
        client.send(feedback("0.05", "VectorAdjustmentFeedbackHandler", new Vec3(1, 2, 3)));
        assertThat(client.next("feedback-applied-notification"))
                .contains("handler-name=\"DirectPositionChangeFeedbackHandler\"");
    }

    @Test
    void whatCannotBeUsedIsAnErrorAndTheStepWaitsOn() throws IOException {
        RawClient client = start(waitingForRobot(Tank.world()));
        client.next("timestep-advanced-notification");
        client.send(feedback("0.05", "Magic", Vec3.ZERO));
        assertThat(client.next())
                .contains("error-response")
                .contains(
                        "no feedback processor has the name 'Magic'; there are"
                                + " DirectPositionChangeFeedbackHandler, IgnoreFeedbackHandler,"
                                + " KalmanFilterFeedbackHandler,"
                                + " VectorAdjustmentFeedbackHandler");
        client.send(feedback("0.1", "DirectPositionChangeFeedbackHandler", Vec3.ZERO));
        assertThat(client.next()).contains("feedback for 0.1 s is too early");
        client.send(feedback("0.0", "DirectPositionChangeFeedbackHandler", Vec3.ZERO));
        assertThat(client.next()).contains("feedback for 0.0 s is too late");
        client.send(feedback("NaN", "DirectPositionChangeFeedbackHandler", Vec3.ZERO));
        assertThat(client.next())
                .contains("code=\"INVALID_VALUE\"")
                .contains("expected a finite number, but found 'NaN'");
        client.send(feedback("0.05", "DirectPositionChangeFeedbackHandler", new Vec3(0, 1, 0)));
        assertThat(client.next("feedback-applied")).contains("timestamp=\"0.05\"");
    }

    /** A number that no distance can be told of must not stop everybody's simulation. */
    @Test
    void whatIsMuchTooLargeIsRefusedAndTheSimulationGoesOn() throws IOException {
        RawClient client = start(waitingForRobot(Tank.world()));
        client.next("timestep-advanced-notification");
        client.send(feedback("0.05", "DirectPositionChangeFeedbackHandler", new Vec3(1e300, 0, 0)));
        assertThat(client.next("error-response"))
                .contains("code=\"INVALID_VALUE\"")
                .contains("was measured more than 1.0E9 m away from what the model has");
        assertThat(client.next("timestep-advanced-notification")).contains("ACTUAL");
        assertThat(client.ask("s", "<get-simulator-state-request/>")).contains("step=\"1\"");
    }

    @Test
    void asynchronousFeedbackCorrectsWithoutAWait() throws IOException {
        RawClient client =
                start(
                        Simulator.of(Tank.world())
                                .timestepper(new AsynchronousFeedbackTimestepper()));
        assertThat(client.next("timestep-advanced-notification")).contains("ACTUAL");
        client.send(
                feedback("0.05", "DirectPositionChangeFeedbackHandler", new Vec3(0, 0, 7))
                        + "<auvsml><step-command/></auvsml>");
        assertThat(client.next("feedback-applied")).contains("timestamp=\"0.05\"");
        String moved = client.next();
        assertThat(moved).contains("timestamp=\"0.1\"");
        assertThat(RawClient.number(moved, "position", "z")).isCloseTo(7, within(1e-12));
    }
}
