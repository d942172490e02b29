package org.auvsim.server;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.volume.Sphere;
import org.auvsim.server.feedback.SimpleFixedTimeFeedbackTimestepper;
import org.auvsim.server.net.TcpTransport;
import org.auvsim.server.simulator.Simulator;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import java.io.IOException;
import java.time.Duration;
import java.util.List;
import java.util.OptionalDouble;

/** A robot that measures more than its position, or something wrong, over a real socket. */
@Timeout(60)
class StateFeedbackConversationTest {
    private static final String DIRECT = "DirectPositionChangeFeedbackHandler";
    private static final String POSITION = "<position x=\"0.1\" y=\"0.0\" z=\"0.0\"/>";

    private final TcpTransport tcp = TcpTransport.onLoopback(0);

    /** Long enough for a test to fail if the wait does not end with the robot's answer. */
    private final Simulator simulator =
            Simulator.of(
                            Tank.builder()
                                    .add(
                                            WorldObjectDefinition.named("pier")
                                                    .id(9)
                                                    .fixed()
                                                    .volume(new Sphere(1))
                                                    .position(0, -50, 0)
                                                    .build())
                                    .build())
                    .timestepper(
                            new SimpleFixedTimeFeedbackTimestepper(
                                    Duration.ofMinutes(2), List.of("client 1")))
                    .rate(OptionalDouble.empty())
                    .paused()
                    .transport(tcp)
                    .start();

    private final RawClient robot;

    StateFeedbackConversationTest() throws IOException {
        robot = RawClient.welcomed(tcp.port());
    }

    @BeforeEach
    void aStepWaits() throws IOException {
        robot.ask(
                "r",
                "<listener-registration-request-command register=\"1\"><world-object"
                        + " id=\"*\"><listener type=\"TimestepAdvanced\"/><listener"
                        + " type=\"FeedbackApplied\"/></world-object>"
                        + "</listener-registration-request-command>");
        robot.send("<auvsml><step-command/></auvsml>");
    }

    @AfterEach
    void close() throws IOException {
        robot.close();
        simulator.close();
    }

    private static String state(long object, String attributes, String inner) {
        return "<auvsml><different-state-feedback-message world-object-id=\""
                + object
                + "\" timestamp=\"0.05\" "
                + attributes
                + ">"
                + inner
                + "</different-state-feedback-message></auvsml>";
    }

    private static String direct(String inner) {
        return state(1, "handler-name=\"" + DIRECT + "\"", inner);
    }

    private static String covariance(String... rows) {
        return "<covariance><row values=\""
                + String.join("\"/><row values=\"", rows)
                + "\"/></covariance>";
    }

    @Test
    void aStateInNorthEastDownIsTakenAndItsErrorsAreTold() throws IOException {
        robot.next("timestep-advanced-notification");
        robot.send(
                state(
                        1,
                        "handler-name=\"" + DIRECT + "\" frame=\"NED\"",
                        "<position x=\"3.0\" y=\"4.0\" z=\"0.0\"/>"
                                + "<orientation w=\"1.0\" x=\"0.0\" y=\"0.0\" z=\"0.0\"/>"
                                + "<velocity x=\"0.5\" y=\"0.0\" z=\"0.0\"/>"));
        String applied = robot.next("feedback-applied-notification");
        assertThat(applied).contains("converged=\"1\"").doesNotContain("angular-velocity-error");
        assertThat(RawClient.number(applied, "feedback-applied", "error-before"))
                .isCloseTo(5, within(1e-12));
        assertThat(RawClient.number(applied, "measured-position", "x")).isCloseTo(4, within(1e-12));
        assertThat(RawClient.number(applied, "measured-position", "y")).isCloseTo(3, within(1e-12));
        assertThat(RawClient.number(applied, "feedback-applied", "angle-error-before"))
                .isCloseTo(Math.PI / 2, within(1e-12));
        assertThat(RawClient.number(applied, "feedback-applied", "velocity-error-before"))
                .isCloseTo(0.5, within(1e-12));
        assertThat(RawClient.number(applied, "feedback-applied", "error-after")).isZero();
        assertThat(RawClient.number(applied, "feedback-applied", "velocity-error-after"))
                .isCloseTo(0, within(1e-15));
    }

    @Test
    void theFilterWeighsAPositionByItsCovariance() throws IOException {
        robot.next("timestep-advanced-notification");
        robot.send(
                state(
                        1,
                        "handler-name=\"KalmanFilterFeedbackHandler\"",
                        POSITION + covariance("1 0 0", "0 1 0", "0 0 1")));
        String applied = robot.next("feedback-applied-notification");
        assertThat(RawClient.number(applied, "feedback-applied", "error-before"))
                .isCloseTo(0.1, within(1e-12));
        // 1 m of initial error against 1 m of the measurement
        assertThat(RawClient.number(applied, "feedback-applied", "error-after"))
                .isCloseTo(0.05, within(1e-12));
    }

    /** What cannot be read is answered as soon as it may be, and changes nothing. */
    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            textBlock =
                    """
                    ''                                              | must state a position
                    <position x="NaN" y="0" z="0"/>                 | expected a finite number, but found 'NaN'
                    <velocity x="1e999" y="0" z="0"/>               | expected a finite number
                    <orientation w="2" x="0" y="0" z="0"/>          | a quaternion of length 1
                    <position x="0" y="0" z="0"/><covariance><row values="1 0 0"/></covariance> | must have 3 rows of 3 numbers, but has 1
                    <position x="0" y="0" z="0"/><covariance><row values="1"/></covariance> | the covariance of 3 measured numbers must have 3 rows of 3 numbers, but has 1
                    <position x="0" y="0" z="0"/><covariance><row values="1 0 0"/><row values="0 1 0"/><row values="0 0 0"/></covariance> | must be positive definite
                    <position x="0" y="0" z="0"/><covariance><row values="1 3 0"/><row values="3 1 0"/><row values="0 0 1"/></covariance> | row 2
                    <position x="0" y="0" z="0"/><covariance><row values="1 0.1 0"/><row values="0.2 1 0"/><row values="0 0 1"/></covariance> | must be symmetric
                    """)
    void whatCannotBeReadIsRefused(String inner, String why) throws IOException {
        robot.next("timestep-advanced-notification");
        robot.send(direct(inner) + direct(POSITION));
        String answers = robot.next();
        while (!answers.contains("ACTUAL") || !answers.contains("error-response")) {
            answers += robot.next();
        }
        assertThat(answers).contains("code=\"INVALID_VALUE\"").contains(why);
        assertThat(answers).containsOnlyOnce("<feedback-applied-notification");
    }

    @Test
    void anUnknownObjectIsRefusedAtOnce() throws IOException {
        robot.next("timestep-advanced-notification");
        robot.send(state(77, "handler-name=\"" + DIRECT + "\"", POSITION));
        assertThat(robot.next("error-response")).contains("code=\"UNKNOWN_ENTITY\"").contains("77");
        robot.send(direct(POSITION));
        assertThat(robot.next("feedback-applied")).contains("world-object-id=\"1\"");
    }

    @Test
    void aFixedObjectStaysWhereItIs() throws IOException {
        robot.next("timestep-advanced-notification");
        robot.send(state(9, "handler-name=\"VectorAdjustmentFeedbackHandler\"", POSITION));
        assertThat(robot.next("error-response"))
                .contains("code=\"REFUSED\"")
                .contains("'pier' is fixed, and stays where it is");
        robot.next("timestep-advanced-notification");
        Vec3 pier = simulator.ask(world -> world.object(9).position());
        assertThat(pier).isEqualTo(new Vec3(0, -50, 0));
    }

    @Test
    void anotherClientsObjectIsRefusedWithTheHoldersName() throws IOException {
        robot.next("timestep-advanced-notification");
        try (RawClient other = RawClient.welcomed(tcp.port())) {
            robot.send(direct(POSITION));
            robot.next("feedback-applied");
            assertThat(other.ask("o", inner(direct(POSITION))))
                    .contains("error-response")
                    .contains("client 1");
        }
    }

    private static String inner(String root) {
        return root.replace("<auvsml>", "").replace("</auvsml>", "");
    }

    /** It is finite, but the object's momentum would not be: nothing of it is used. */
    @Test
    void whatIsTooLargeToBeUsedChangesNothing() throws IOException {
        robot.next("timestep-advanced-notification");
        robot.send(direct(POSITION + "<velocity x=\"1.7e308\" y=\"0\" z=\"0\"/>"));
        assertThat(robot.next("error-response"))
                .contains("code=\"INVALID_VALUE\"")
                .contains("'Bob' was measured more than 1000000.0 m/s beside what the model has");
        robot.next("timestep-advanced-notification");
        robot.send("<auvsml><step-command/></auvsml>");
        robot.next("timestep-advanced-notification");
        robot.send(direct(POSITION).replace("0.05", "0.1"));
        assertThat(RawClient.number(robot.next("feedback-applied"), "feedback", "error-before"))
                .isCloseTo(0.1, within(1e-12));
    }
}
