package org.auvsim.server;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.core.effect.Gravity;
import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.volume.Box;
import org.auvsim.core.volume.HalfSpace;
import org.auvsim.core.world.World;
import org.auvsim.server.net.TcpTransport;
import org.auvsim.server.simulator.Simulator;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

import java.io.IOException;

/** Clients hear what keeps steps from getting stuck or diverging, over real sockets. */
@Timeout(60)
class StepReportConversationTest {
    private static final String STEP_DONE =
            "<auvsml><timestep-advanced-notification timestamp=\"0.05\""
                    + " state-type=\"ACTUAL\"/></auvsml>";

    private static World boxOnTheFloor() {
        return World.builder()
                .add(WorldObjectDefinition.named("Floor").volume(new HalfSpace()).fixed().build())
                .add(
                        WorldObjectDefinition.named("Box")
                                .volume(new Box(new Vec3(1, 1, 1)))
                                .mass(1)
                                .restitution(0.5)
                                .effect(new Gravity(9.81))
                                .position(0, 0, 0.5)
                                .build())
                .build();
    }

    /** Listens to these events of object 2 in a world that is paused, and asks for a step. */
    private static RawClient stepping(int port, String... types) throws IOException {
        RawClient client = RawClient.welcomed(port);
        StringBuilder listeners = new StringBuilder();
        for (String type : types) {
            listeners.append("<listener type=\"").append(type).append("\"/>");
        }
        client.ask(
                "r",
                "<listener-registration-request-command register=\"1\"><world-object id=\"2\">"
                        + listeners
                        + "</world-object></listener-registration-request-command>");
        client.send("<auvsml><step-command/></auvsml>");
        return client;
    }

    @Test
    void aBoxThatRestsIsReportedBeforeTheStepIsDone() throws IOException {
        TcpTransport tcp = TcpTransport.onLoopback(0);
        try (Simulator _ = Simulator.of(boxOnTheFloor()).paused().transport(tcp).start();
                RawClient client = stepping(tcp.port(), "StepReport", "TimestepAdvanced")) {
            assertThat(client.next())
                    .isEqualTo(
                            "<auvsml><step-report-notification timestamp=\"0.05\" sub-steps=\"0\""
                                    + " held-pairs=\"1\" quick-hits=\"0\""
                                    + " crowded-hits=\"0\" lowered-hits=\"0\""
                                    + " unsolved-islands=\"0\"/></auvsml>");
            assertThat(client.next()).isEqualTo(STEP_DONE);
        }
    }

    @Test
    void whoListensToAllHearsIt() throws IOException {
        TcpTransport tcp = TcpTransport.onLoopback(0);
        try (Simulator _ = Simulator.of(boxOnTheFloor()).paused().transport(tcp).start();
                RawClient client = stepping(tcp.port(), "*ALL*")) {
            assertThat(client.next("step-report-notification")).contains("held-pairs=\"1\"");
        }
    }

    @Test
    void whoDoesNotListenToItDoesNotHearIt() throws IOException {
        TcpTransport tcp = TcpTransport.onLoopback(0);
        try (Simulator _ = Simulator.of(boxOnTheFloor()).paused().transport(tcp).start();
                RawClient client = stepping(tcp.port(), "TimestepAdvanced")) {
            assertThat(client.next()).isEqualTo(STEP_DONE);
        }
    }

    @Test
    void aQuietWorldIsNotReported() throws IOException {
        TcpTransport tcp = TcpTransport.onLoopback(0);
        try (Simulator _ = Simulator.of(Tank.world()).paused().transport(tcp).start();
                RawClient client = stepping(tcp.port(), "StepReport", "TimestepAdvanced")) {
            assertThat(client.next()).isEqualTo(STEP_DONE);
        }
    }
}
