package org.auvsim.server;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.auvsml.Role;
import org.auvsim.server.feedback.AsynchronousFeedbackTimestepper;
import org.auvsim.server.net.TcpTransport;
import org.auvsim.server.simulator.Simulator;
import org.auvsim.server.simulator.SimulatorBuilder;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;

/** Who may do what, and to which object, over real sockets. */
@Timeout(60)
class ControlConversationTest {
    private static final String PUSH =
            "<apply-direct-force-command world-object-id=\"1\" name=\"push\" orientation=\"WORLD\">"
                    + "<force-vector x=\"1\" y=\"0\" z=\"0\"/></apply-direct-force-command>";
    private static final String FEEDBACK =
            "<different-position-feedback-message world-object-id=\"1\" timestamp=\"0\""
                    + " handler-name=\"DirectPositionChangeFeedbackHandler\">"
                    + "<virtual-position x=\"0\" y=\"0\" z=\"0\"/>"
                    + "<actual-position x=\"1\" y=\"0\" z=\"0\"/>"
                    + "<old-position x=\"0\" y=\"0\" z=\"0\"/>"
                    + "</different-position-feedback-message>";

    private final TcpTransport tcp = TcpTransport.onLoopback(0);
    private final List<AutoCloseable> open = new ArrayList<>();

    private void start(SimulatorBuilder builder) {
        open.add(builder.transport(tcp).paused().start());
    }

    private static SimulatorBuilder tank() {
        return Simulator.of(Tank.world()).timestepper(new AsynchronousFeedbackTimestepper());
    }

    private RawClient client() throws IOException {
        RawClient client = RawClient.welcomed(tcp.port());
        open.add(client);
        return client;
    }

    @AfterEach
    void end() throws Exception {
        for (AutoCloseable each : open.reversed()) {
            each.close();
        }
    }

    private static void assertRefused(String answer) {
        assertThat(answer)
                .contains("code=\"NOT_IN_CONTROL\"")
                .contains("client 1 (127.0.0.1:")
                .contains(") controls 'Bob' (id 1); wait until it lets go");
    }

    @Test
    void whoCommandsAnObjectAloneCorrectsIt() throws IOException {
        start(tank());
        RawClient pilot = client();
        RawClient robot = client();
        assertThat(pilot.ask("1", PUSH)).contains("command-done-response");
        assertRefused(robot.ask("1", FEEDBACK));
        assertThat(pilot.ask("2", FEEDBACK)).contains("command-done-response");
    }

    @Test
    void whoCorrectsAnObjectAloneCommandsIt() throws IOException {
        start(tank());
        RawClient robot = client();
        RawClient pilot = client();
        assertThat(robot.ask("1", FEEDBACK)).contains("command-done-response");
        assertRefused(pilot.ask("1", PUSH));
        assertRefused(pilot.ask("2", "<take-control-command world-object-id=\"1\"/>"));
        robot.ask("2", "<release-control-command world-object-id=\"1\"/>");
        assertThat(pilot.ask("3", PUSH)).contains("command-done-response");
    }

    @Test
    void anAdministratorChangesWhatAnotherControls() throws IOException {
        start(tank());
        client().ask("1", PUSH);
        assertThat(
                        client().ask(
                                        "1",
                                        "<add-effect-command world-object-id=\"1\"><gravity/>"
                                                + "</add-effect-command>"))
                .contains("command-done-response");
    }

    @Test
    void aViewerAsksAndListensButCommandsNothing() throws IOException {
        start(tank().role(Role.VIEWER));
        RawClient viewer = new RawClient(tcp.port());
        open.add(viewer);
        assertThat(viewer.next("welcome-message")).contains("role=\"viewer\"");
        assertThat(viewer.ask("1", "<get-world-object-list-command/>")).contains("name=\"Bob\"");
        assertThat(viewer.ask("2", "<get-simulator-state-request/>")).contains("running=\"0\"");
        assertThat(
                        viewer.ask(
                                "3",
                                "<listener-registration-request-command"
                                    + " register=\"1\"><world-object id=\"*\"><listener"
                                    + " type=\"*ALL*\"/>"
                                    + "</world-object></listener-registration-request-command>"))
                .contains("command-done-response");
        assertThat(viewer.ask("4", "<take-control-command world-object-id=\"1\"/>"))
                .contains("code=\"NOT_ALLOWED\"")
                .contains(
                        "take-control-command needs the role controller, but client 1 is a viewer");
        assertThat(viewer.ask("5", PUSH)).contains("code=\"NOT_ALLOWED\"");
        assertThat(viewer.ask("6", FEEDBACK))
                .contains("different-position-feedback-message needs the role controller");
        assertThat(viewer.ask("7", "<step-command/>")).contains("needs the role admin");
    }

    @Test
    void aControllerFliesButDoesNotChangeTheWorld() throws IOException {
        start(tank().role(Role.CONTROLLER));
        RawClient controller = client();
        assertThat(controller.ask("1", PUSH)).contains("command-done-response");
        assertThat(controller.ask("2", FEEDBACK)).contains("command-done-response");
        assertThat(controller.ask("3", "<remove-entity-command entity-id=\"2\"/>"))
                .contains("code=\"NOT_ALLOWED\"")
                .contains(
                        "remove-entity-command needs the role admin, but client 1 is a controller");
        assertThat(controller.ask("4", "<get-world-object-list-command/>"))
                .contains("name=\"Carl\"");
    }
}
