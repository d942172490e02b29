package org.auvsim.server;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.core.actuator.Fin;
import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.volume.Sphere;
import org.auvsim.core.world.World;
import org.auvsim.server.net.TcpTransport;
import org.auvsim.server.simulator.Simulator;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

import java.io.IOException;
import java.util.Optional;
import java.util.OptionalDouble;

/** Fins are listed and turned over real sockets. */
@Timeout(60)
class FinConversationTest {
    private static Fin fin(String name, double maximumAngle) {
        return new Fin(
                name,
                0.01,
                3,
                new Vec3(-0.5, 0, 0),
                new Vec3(1, 0, 0),
                new Vec3(0, 0, 1),
                0,
                0,
                0.35,
                1000,
                0,
                0,
                maximumAngle,
                OptionalDouble.empty(),
                Optional.empty());
    }

    private static World aGlider() {
        return World.builder()
                .add(
                        WorldObjectDefinition.named("Glider")
                                .volume(new Sphere(0.2))
                                .mass(30)
                                .velocity(2, 0, 0)
                                .component(fin("Rudder", 0.3))
                                .component(fin("Keel", 0))
                                .build())
                .build();
    }

    @Test
    void aRudderThatIsTurnedTurnsItsVehicle() throws IOException {
        TcpTransport tcp = TcpTransport.onLoopback(0);
        try (Simulator _ = Simulator.of(aGlider()).paused().transport(tcp).start();
                RawClient client = RawClient.welcomed(tcp.port())) {
            client.ask(
                    "0",
                    "<listener-registration-request-command register=\"1\"><world-object id=\"1\">"
                            + "<listener type=\"KinematicState\"/></world-object>"
                            + "</listener-registration-request-command>");
            assertThat(client.ask("1", "<get-control-surface-list-request agent-id=\"1\"/>"))
                    .isEqualTo(
                            "<auvsml request-id=\"1\"><control-surface-list-response"
                                    + " agent-id=\"1\"><control-surface name=\"Rudder\"/>"
                                    + "</control-surface-list-response></auvsml>");
            assertThat(client.ask("2", set("Rudder", 0.5)))
                    .contains("INVALID_VALUE")
                    .contains("the angle of fin 'Rudder' must be -0.3 to 0.3 rad, but is 0.5 rad");
            assertThat(client.ask("3", set("Sail", 0.1)))
                    .contains("'Glider' has no fin 'Sail'; it has [Rudder, Keel]");
            assertThat(client.ask("4", set("Rudder", 0.1)))
                    .isEqualTo("<auvsml request-id=\"4\"><command-done-response/></auvsml>");
            client.send("<auvsml><step-command/></auvsml>");
            // Lift to port at the stern turns the bow to starboard.
            String state = client.next("kinematic-state-message");
            assertThat(RawClient.number(state, "angular-velocity", "z")).isNegative();
            assertThat(RawClient.number(state, "velocity", "y")).isPositive();
        }
    }

    private static String set(String fin, double angle) {
        return "<set-control-surface-command world-object-id=\"1\" name=\"%s\" angle=\"%s\"/>"
                .formatted(fin, angle);
    }
}
