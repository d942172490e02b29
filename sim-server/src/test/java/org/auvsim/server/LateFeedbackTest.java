package org.auvsim.server;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.auvsim.core.entity.Behavior;
import org.auvsim.core.entity.Frame;
import org.auvsim.core.entity.MovementState;
import org.auvsim.core.entity.NamedForce;
import org.auvsim.core.entity.WorldObject;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.world.World;
import org.auvsim.server.feedback.AsynchronousFeedbackTimestepper;
import org.auvsim.server.net.TcpTransport;
import org.auvsim.server.simulator.Simulator;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

import java.io.IOException;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.Function;

/** Feedback that comes late corrects the past, over a real socket. */
@Timeout(60)
class LateFeedbackTest {
    private static final String DIRECT = "DirectPositionChangeFeedbackHandler";

    private final TcpTransport tcp = TcpTransport.onLoopback(0);
    private Optional<Simulator> simulator = Optional.empty();
    private Optional<RawClient> robot = Optional.empty();

    @BeforeEach
    void start() throws IOException {
        simulator =
                Optional.of(
                        Simulator.of(Tank.world())
                                .timestepper(new AsynchronousFeedbackTimestepper())
                                .feedbackHorizon(0.5)
                                .rate(OptionalDouble.empty())
                                .paused()
                                .transport(tcp)
                                .start());
        robot = Optional.of(RawClient.welcomed(tcp.port()));
        client().ask(
                        "r",
                        "<listener-registration-request-command register=\"1\"><world-object"
                                + " id=\"*\"><listener type=\"*ALL*\"/></world-object>"
                                + "</listener-registration-request-command>");
    }

    @AfterEach
    void close() throws IOException {
        client().close();
        simulator().close();
    }

    private RawClient client() {
        return robot.orElseThrow();
    }

    private Simulator simulator() {
        return simulator.orElseThrow();
    }

    private <T> T world(Function<World, T> question) {
        return simulator().ask(question);
    }

    private void steps(int count) {
        for (int i = 0; i < count; i++) {
            simulator().advanceTimestep();
        }
    }

    private static String position(long object, double time, String handler, double y) {
        return ("<different-position-feedback-message world-object-id=\"%d\" timestamp=\"%s\""
                        + " handler-name=\"%s\"><virtual-position x=\"0.0\" y=\"0.0\" z=\"0.0\"/>"
                        + "<actual-position x=\"0.0\" y=\"%s\" z=\"0.0\"/>"
                        + "<old-position x=\"0.0\" y=\"0.0\" z=\"0.0\"/>"
                        + "</different-position-feedback-message>")
                .formatted(object, time, handler, y);
    }

    private static NamedForce push(double x) {
        return NamedForce.direct("engine", Frame.WORLD, new Vec3(x, 0, 0));
    }

    private static String pushing(long object, double x) {
        return ("<apply-direct-force-command world-object-id=\"%d\" name=\"engine\""
                        + " orientation=\"WORLD\"><force-vector x=\"%s\" y=\"0.0\" z=\"0.0\"/>"
                        + "</apply-direct-force-command>")
                .formatted(object, x);
    }

    @Test
    void theWorldGoesBackAndOnAgainWithAllThatWasCommanded() throws IOException {
        steps(4);
        client().ask("a", pushing(1, 4));
        steps(4);
        assertThat(client().ask("f", position(1, 0.2, DIRECT, 3))).contains("command-done");
        steps(1);
        assertThat(client().next("history-revised"))
                .containsPattern("revision=\"1\" from=\"0.15[0-9]*\" to=\"0.4\"");
        assertThat(client().next()).contains("feedback-applied").contains("timestamp=\"0.2\"");
        String moved = client().next();
        assertThat(moved).contains("movement-state-change").contains("timestamp=\"0.4\"");
        assertThat(RawClient.number(moved, "position", "y")).isCloseTo(3, within(1e-12));
        World alone = Tank.world();
        for (int i = 0; i < 9; i++) {
            if (i == 4) {
                alone.object(1).setPosition(new Vec3(0, 3, 0));
                alone.object(1).applyForce(push(4));
            }
            alone.advanceTimestep();
        }
        assertThat(this.<Long>world(World::stateHash)).isEqualTo(alone.stateHash());
    }

    @Test
    void whatNobodyCorrectsStaysTheSameBitForBit() throws IOException {
        client().ask("a", pushing(2, 4));
        steps(3);
        client().ask("b", pushing(2, -7));
        steps(4);
        client().ask("f", position(1, 0.1, DIRECT, 3));
        steps(1);
        World alone = Tank.world();
        alone.object(2).applyForce(push(4));
        for (int i = 0; i < 8; i++) {
            if (i == 3) {
                alone.object(2).applyForce(push(-7));
            }
            alone.advanceTimestep();
        }
        assertThat(this.<MovementState>world(w -> w.object(2).movementState()))
                .isEqualTo(alone.object(2).movementState());
    }

    @Test
    void outOfOrderIsTheSameAsInOrder() throws IOException {
        steps(8);
        client().ask("1", position(1, 0.3, DIRECT, 3));
        steps(1);
        client().ask("2", position(1, 0.2, DIRECT, 2));
        steps(1);
        assertThat(client().next("history-revised")).contains("revision=\"2\"");
        World alone = Tank.world();
        for (int step = 1; step <= 10; step++) {
            alone.advanceTimestep();
            if (step == 4 || step == 6) {
                alone.object(1).setPosition(new Vec3(0, step / 2.0, 0));
            }
        }
        assertThat(this.<Long>world(World::stateHash)).isEqualTo(alone.stateHash());
    }

    @Test
    void eachFeedbackIsToldOnce() throws IOException {
        steps(8);
        for (int k = 1; k <= 3; k++) {
            client().ask("f" + k, position(1, 0.1, DIRECT, k));
            steps(1);
        }
        client().send("<auvsml><shutdown-simulator-command/></auvsml>");
        assertThat(client().rest().split("<feedback-applied-notification", -1)).hasSize(2);
    }

    @Test
    void whoSentItStillControlsTheObject() throws IOException {
        steps(4);
        client().ask("f", position(1, 0.1, DIRECT, 3));
        steps(1);
        client().next("history-revised");
        try (RawClient other = RawClient.welcomed(tcp.port())) {
            assertThat(other.ask("g", position(1, 0.2, DIRECT, 4)))
                    .contains("NOT_IN_CONTROL")
                    .contains("client 1");
        }
    }

    @Test
    void aSnapshotThatWasTakenSinceStaysAsItIs() throws IOException {
        steps(4);
        client().ask("s", "<take-snapshot-command name=\"before\"/>");
        long then = world(World::stateHash);
        client().ask("f", position(1, 0.1, DIRECT, 3));
        steps(1);
        client().next("history-revised");
        client().ask("r", "<restore-snapshot-command name=\"before\"/>");
        assertThat(this.<Long>world(World::stateHash)).isEqualTo(then);
    }

    @Test
    void feedbackThatWaitsWhenTheWorldGoesElsewhereIsRefused() throws IOException {
        steps(4);
        client().ask("s", "<take-snapshot-command name=\"here\"/>");
        client().ask("f", position(1, 0.1, DIRECT, 3));
        client().send("<auvsml><restore-snapshot-command name=\"here\"/></auvsml>");
        assertThat(client().next("error-response"))
                .contains(
                        "feedback for 0.1 s cannot be used any more: the world has gone elsewhere");
        steps(1);
        assertThat(this.<Double>world(w -> w.object(1).position().y())).isZero();
    }

    @Test
    void feedbackForAnObjectThatWasNotThereThenIsRefusedAndNothingIsRevised() throws IOException {
        steps(4);
        client().ask(
                        "a",
                        "<add-world-object-command><world-object name=\"Late\" mass=\"1\">"
                                + "<sphere radius=\"1\"/><position x=\"0.0\" y=\"50.0\""
                                + " z=\"0.0\"/></world-object></add-world-object-command>");
        steps(1);
        client().ask("f", position(5, 0.1, DIRECT, 3));
        steps(1);
        assertThat(client().next("error-response")).contains("no world object has the id 5 at 0.1");
        client().send("<auvsml><shutdown-simulator-command/></auvsml>");
        assertThat(client().rest()).doesNotContain("history-revised");
    }

    @Test
    void anObjectThatWasAddedSinceKeepsItsId() throws IOException {
        steps(2);
        String added =
                client().ask(
                                "a",
                                "<add-world-object-command><world-object name=\"Late\" mass=\"1\">"
                                        + "<sphere radius=\"1\"/><position x=\"0.0\" y=\"50.0\""
                                        + " z=\"0.0\"/></world-object></add-world-object-command>");
        assertThat(added).contains("world-object-id=\"5\"");
        steps(2);
        client().ask("f", position(1, 0.1, DIRECT, 3));
        steps(1);
        assertThat(this.<Long>world(w -> w.object("Late").id())).isEqualTo(5);
        assertThat(client().ask("p", pushing(5, 1))).contains("command-done");
    }

    @Test
    void feedbackFromBeforeTheHorizonIsRefused() throws IOException {
        steps(20);
        assertThat(client().ask("1", position(1, 0.3, DIRECT, 3)))
                .contains("feedback for 0.3 s is too late: the world is at 1.0 s")
                .contains("its past can be corrected back to");
        steps(1);
        assertThat(this.<Double>world(w -> w.object(1).position().y())).isZero();
    }

    /** Breaks where the past, as it was, did not bring it. */
    private record Fragile(String name) implements Behavior {
        @Override
        public void act(double time, WorldObject self) {
            if (self.position().y() > 5) {
                throw new IllegalStateException("the rudder of '%s' broke".formatted(self.name()));
            }
        }
    }

    @Test
    void aPastThatCannotBeMadeAgainStaysAsItWas() throws IOException {
        world(
                w -> {
                    w.object(1).add(new Fragile("rudder"));
                    return true;
                });
        steps(6);
        long before = world(World::stateHash);
        client().send("<auvsml>" + position(1, 0.1, DIRECT, 9) + "</auvsml>");
        client().ask("s", "<get-simulator-state-request/>");
        simulator().advanceTimestep();
        assertThat(client().next("error-response"))
                .contains("the past cannot be corrected with this feedback")
                .contains("the rudder of 'Bob' broke");
        World alone = Tank.world();
        for (int i = 0; i < 7; i++) {
            alone.advanceTimestep();
        }
        assertThat(this.<Long>world(World::stateHash))
                .isNotEqualTo(before)
                .isEqualTo(alone.stateHash());
    }

    /** Lets its engine go where the past, as it was, did not bring it. */
    private record LetsGo(String name) implements Behavior {
        @Override
        public void act(double time, WorldObject self) {
            if (self.position().y() > 5) {
                self.removeForce("engine");
            }
        }
    }

    @Test
    void aCommandThatFailsInTheCorrectedPastIsReportedToItsSender() throws IOException {
        world(
                w -> {
                    w.object(1).add(new LetsGo("let go"));
                    return true;
                });
        client().ask("m", pushing(1, 1));
        steps(6);
        client().ask("x", "<remove-force-command world-object-id=\"1\" force-name=\"engine\"/>");
        steps(1);
        client().ask("f", position(1, 0.1, DIRECT, 9));
        steps(1);
        client().next("history-revised");
        assertThat(client().next("error-response"))
                .contains("remove-force-command, carried out before, is refused now")
                .contains("'Bob' has no force 'engine'");
    }
}
