package org.auvsim.server;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.auvsim.core.communication.AcousticModem;
import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.sensor.DepthSensor;
import org.auvsim.core.sensor.Sampling;
import org.auvsim.core.sensor.ScalarErrors;
import org.auvsim.core.volume.Sphere;
import org.auvsim.core.world.World;
import org.auvsim.server.net.TcpTransport;
import org.auvsim.server.simulator.Simulator;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

import java.io.IOException;

/** Clients hear what sensors read, over real sockets. */
@Timeout(60)
class SensorConversationTest {
    private static World diver() {
        return World.builder()
                .add(
                        WorldObjectDefinition.named("Diver")
                                .volume(new Sphere(0.5))
                                .mass(1)
                                .position(0, 0, -3)
                                .velocity(0, 0, -1)
                                .component(depth("Keller", new Sampling(40, 0, 0, 0)))
                                .component(depth("Late", new Sampling(40, 0.01, 0, 0)))
                                .build())
                .build();
    }

    private static DepthSensor depth(String name, Sampling sampling) {
        return new DepthSensor(name, Vec3.ZERO, 0, 1025, 1025, ScalarErrors.NONE, sampling);
    }

    private static String registration(String type) {
        return "<listener-registration-request-command register=\"1\"><world-object id=\"1\">"
                + "<listener type=\""
                + type
                + "\"/></world-object></listener-registration-request-command>";
    }

    private static String reading(String time, String sensor, String measured, String depth) {
        return "<auvsml><sensor-reading-message timestamp=\"%s\" world-object-id=\"1\" sensor=\"%s\" measured-at=\"%s\"><depth-reading depth=\"%s\"/></sensor-reading-message></auvsml>"
                .formatted(time, sensor, measured, depth);
    }

    @Test
    void readingsComeWithTheTimesOfMeasurementAndArrival() throws IOException {
        TcpTransport tcp = TcpTransport.onLoopback(0);
        try (Simulator _ = Simulator.of(diver()).paused().transport(tcp).start();
                RawClient client = RawClient.welcomed(tcp.port())) {
            client.ask("r", registration("SensorReading"));
            client.send("<auvsml><step-command/></auvsml>");

            assertThat(client.next()).isEqualTo(reading("0.025", "Keller", "0.025", "3.025"));
            assertThat(client.next()).isEqualTo(reading("0.035", "Late", "0.025", "3.025"));
            assertThat(client.next()).isEqualTo(reading("0.05", "Keller", "0.05", "3.05"));
        }
    }

    @Test
    void whoListensToAllHearsThemAndWhoDoesNotDoesNot() throws IOException {
        TcpTransport tcp = TcpTransport.onLoopback(0);
        try (Simulator _ = Simulator.of(diver()).paused().transport(tcp).start();
                RawClient all = RawClient.welcomed(tcp.port());
                RawClient steps = RawClient.welcomed(tcp.port())) {
            all.ask("r", registration("*ALL*"));
            steps.ask("r", registration("TimestepAdvanced"));
            steps.send("<auvsml><step-command/></auvsml>");

            assertThat(all.next("sensor-reading-message")).contains("Keller");
            assertThat(steps.next()).contains("timestep-advanced-notification");
        }
    }

    @Test
    void aMessageIsHeardAfterItsTravelTime() throws IOException {
        World world =
                World.builder()
                        .add(withModem(1, "Sender", 0))
                        .add(withModem(2, "Hearer", 31))
                        .build();
        TcpTransport tcp = TcpTransport.onLoopback(0);
        try (Simulator _ = Simulator.of(world).paused().transport(tcp).start();
                RawClient client = RawClient.welcomed(tcp.port())) {
            client.ask("r", registration("Radio").replace("id=\"1\"", "id=\"2\""));
            client.ask("s", send("modem"));
            client.send("<auvsml><step-command/></auvsml>");

            String heard = client.next("radio-message");
            assertThat(RawClient.number(heard, "radio-message", "timestamp"))
                    .isCloseTo(30 / 1500.0, within(1e-8));
            assertThat(heard)
                    .contains(
                            "world-object-id=\"2\" sender-id=\"1\" sender=\"modem\" channel=\"1\""
                                    + " sent-at=\"0.0\" text=\"surface!\"");
            assertThat(client.ask("u", send("VHF")))
                    .contains("'Sender' has no AcousticModem 'VHF'; it has [modem]");
        }
    }

    private static String send(String modem) {
        return "<send-acoustic-message-command world-object-id=\"1\" modem=\"%s\" text=\"surface!\"/>"
                .formatted(modem);
    }

    private static WorldObjectDefinition withModem(long id, String name, double x) {
        return WorldObjectDefinition.named(name)
                .id(id)
                .mass(1)
                .volume(new Sphere(1))
                .position(x, 0, 0)
                .component(new AcousticModem("modem", Vec3.ZERO, "1", 100, 1500, 0, 0))
                .build();
    }

    @Test
    void theSensorsOfAnObjectAreListed() throws IOException {
        TcpTransport tcp = TcpTransport.onLoopback(0);
        try (Simulator _ = Simulator.of(diver()).paused().transport(tcp).start();
                RawClient client = RawClient.welcomed(tcp.port())) {
            assertThat(client.ask("q", "<get-sensor-list-request world-object-id=\"1\"/>"))
                    .isEqualTo(
                            "<auvsml request-id=\"q\"><sensor-list-response world-object-id=\"1\">"
                                    + "<sensor name=\"Keller\" type=\"DepthSensor\" rate=\"40.0\"/>"
                                    + "<sensor name=\"Late\" type=\"DepthSensor\" rate=\"40.0\"/>"
                                    + "</sensor-list-response></auvsml>");
            assertThat(client.ask("u", "<get-sensor-list-request world-object-id=\"9\"/>"))
                    .contains("UNKNOWN_ENTITY")
                    .contains("no world object has the id 9");
        }
    }
}
