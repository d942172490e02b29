package org.auvsim.server;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.core.volume.Sphere;
import org.auvsim.core.world.World;
import org.auvsim.server.net.TcpTransport;
import org.auvsim.server.simulator.Simulator;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

import java.io.IOException;

/** What acts on bodies is listed, added and removed while the world runs, over real sockets. */
@Timeout(60)
class EffectConversationTest {
    private static final String DAMPING =
            "<damping><linear x=\"2.0\" y=\"2.0\" z=\"2.0\"/>"
                    + "<quadratic x=\"0.0\" y=\"0.0\" z=\"0.0\"/>"
                    + "<angular-linear x=\"0.0\" y=\"0.0\" z=\"0.0\"/>"
                    + "<angular-quadratic x=\"0.0\" y=\"0.0\" z=\"0.0\"/></damping>";
    private static final String TIDE =
            "<uniform-current id=\"9\" name=\"Tide\"><velocity x=\"0.5\" y=\"0.0\" z=\"0.0\"/>"
                    + "</uniform-current>";

    private static World aDrifter() {
        return World.builder()
                .add(WorldObjectDefinition.named("Drifter").volume(new Sphere(0.2)).mass(1).build())
                .build();
    }

    private static String done(String id) {
        return "<auvsml request-id=\"" + id + "\"><command-done-response/></auvsml>";
    }

    private static double speedAfterAStep(RawClient client) throws IOException {
        client.send("<auvsml><step-command/></auvsml>");
        return RawClient.number(client.next("kinematic-state-message"), "velocity", "x");
    }

    @Test
    void anEffectAndACurrentCarryABodyAlongUntilTheyAreTakenAway() throws IOException {
        TcpTransport tcp = TcpTransport.onLoopback(0);
        try (Simulator _ = Simulator.of(aDrifter()).paused().transport(tcp).start();
                RawClient client = RawClient.welcomed(tcp.port())) {
            client.ask(
                    "0",
                    "<listener-registration-request-command register=\"1\"><world-object id=\"1\">"
                            + "<listener type=\"KinematicState\"/></world-object>"
                            + "</listener-registration-request-command>");
            String add =
                    "<add-effect-command world-object-id=\"1\"><damping>"
                            + "<linear x=\"2\" y=\"2\" z=\"2\"/></damping></add-effect-command>";
            assertThat(client.ask("1", add)).isEqualTo(done("1"));
            assertThat(client.ask("2", "<add-field-command>" + TIDE + "</add-field-command>"))
                    .isEqualTo(done("2"));
            assertThat(client.ask("3", "<get-effect-list-request world-object-id=\"1\"/>"))
                    .isEqualTo(
                            "<auvsml request-id=\"3\"><effect-list-response world-object-id=\"1\">"
                                    + DAMPING
                                    + "</effect-list-response></auvsml>");
            assertThat(client.ask("4", "<get-field-list-request/>"))
                    .isEqualTo(
                            "<auvsml request-id=\"4\"><field-list-response>"
                                    + TIDE
                                    + "</field-list-response></auvsml>");
            assertThat(speedAfterAStep(client)).isCloseTo(0.5 * (1 - Math.exp(-0.1)), within(1e-5));
            assertThat(
                            client.ask(
                                    "5",
                                    "<remove-effect-command world-object-id=\"1\">"
                                            + DAMPING
                                            + "</remove-effect-command>"))
                    .isEqualTo(done("5"));
            assertThat(speedAfterAStep(client)).isCloseTo(0.5 * (1 - Math.exp(-0.1)), within(1e-5));
            assertThat(client.ask("6", "<remove-entity-command entity-id=\"9\"/>"))
                    .isEqualTo(done("6"));
            assertThat(client.ask("7", "<get-field-list-request/>"))
                    .isEqualTo("<auvsml request-id=\"7\"><field-list-response/></auvsml>");
        }
    }

    @Test
    void whatIsNotThereCannotBeRemovedAndWhatIsTakenNotAdded() throws IOException {
        TcpTransport tcp = TcpTransport.onLoopback(0);
        try (Simulator _ = Simulator.of(aDrifter()).paused().transport(tcp).start();
                RawClient client = RawClient.welcomed(tcp.port())) {
            assertThat(
                            client.ask(
                                    "1",
                                    "<remove-effect-command world-object-id=\"1\"><gravity/>"
                                            + "</remove-effect-command>"))
                    .contains("UNKNOWN_ENTITY")
                    .contains("'Drifter' has no such effect");
            assertThat(
                            client.ask(
                                    "2",
                                    "<add-field-command><uniform-current id=\"1\" name=\"x\">"
                                            + "<velocity x=\"1\" y=\"0\" z=\"0\"/>"
                                            + "</uniform-current></add-field-command>"))
                    .contains("INVALID_VALUE")
                    .contains("the id 1 of 'x' is taken by 'Drifter'");
            assertThat(
                            client.ask(
                                    "3",
                                    "<add-effect-command world-object-id=\"1\">"
                                            + "<buoyancy volume=\"-1\"/></add-effect-command>"))
                    .contains("the volume of buoyancy must be 0 m^3 or more");
            assertThat(client.ask("4", "<get-effect-list-request world-object-id=\"7\"/>"))
                    .contains("UNKNOWN_ENTITY");
        }
    }
}
