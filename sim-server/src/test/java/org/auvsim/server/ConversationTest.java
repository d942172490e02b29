package org.auvsim.server;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.server.net.TcpTransport;
import org.auvsim.server.simulator.Simulator;
import org.junit.jupiter.api.Test;

import java.io.IOException;

/** Listing 7.1 of the thesis, as printed, over a real socket. */
class ConversationTest {
    @Test
    void aClientOfTheThesisIsAnsweredAsPrinted() throws IOException {
        TcpTransport tcp = TcpTransport.onLoopback(0);
        try (Simulator _ = Simulator.of(Tank.world()).transport(tcp).start();
                RawClient client = RawClient.welcomed(tcp.port())) {
            client.send("<auvsml><get-world-object-list-command /></auvsml>");
            assertThat(client.next())
                    .isEqualTo(
                            "<auvsml><world-object-list-response><world-object id=\"1\""
                                    + " type=\"WorldObject\" name=\"Bob\"/><world-object id=\"2\""
                                    + " type=\"WorldObject\" name=\"Carl\"/><world-object id=\"3\""
                                    + " type=\"WorldObject\" name=\"Tank\"/><world-object id=\"4\""
                                    + " type=\"WorldObject\" name=\"myAgent\"/>"
                                    + "</world-object-list-response></auvsml>");
            client.send("<auvsml><get-propulsor-list-request agent-id=\"4\" /></auvsml>");
            assertThat(client.next())
                    .isEqualTo(
                            "<auvsml><propulsor-list-response agent-id=\"4\">"
                                    + "<propulsor name=\"Aft Thruster\"/>"
                                    + "<propulsor name=\"Forward Thruster\"/>"
                                    + "<propulsor name=\"Ventral Thruster\"/>"
                                    + "</propulsor-list-response></auvsml>");
        }
    }
}
