package org.auvsim.server;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.auvsim.auvsml.Role;
import org.auvsim.auvsml.client.AuvsmlClient;
import org.auvsim.auvsml.message.Message;
import org.auvsim.auvsml.message.control.StepCommand;
import org.auvsim.auvsml.message.entity.AddEffectCommand;
import org.auvsim.auvsml.message.entity.DescribeWorldObjectRequest;
import org.auvsim.auvsml.message.entity.WorldObjectDescriptionResponse;
import org.auvsim.auvsml.message.listening.ListenerRegistrationRequestCommand;
import org.auvsim.auvsml.message.movement.TimestepAdvancedNotification;
import org.auvsim.core.actuator.Propulsor;
import org.auvsim.core.effect.Gravity;
import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.core.math.Numbers;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.volume.HeightMap;
import org.auvsim.core.volume.Sphere;
import org.auvsim.core.world.World;
import org.auvsim.server.net.TcpTransport;
import org.auvsim.server.simulator.Simulator;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

import java.io.IOException;
import java.util.Arrays;
import java.util.Collections;

/** World objects as they are now, asked for over real sockets. */
@Timeout(60)
class DescriptionConversationTest {
    private static final String BALL =
            "<world-object id=\"7\" name=\"Ball\" fixed=\"0\" mass=\"2.0\" restitution=\"0.5\""
                    + " friction=\"0.0\" layer=\"0\"><sphere radius=\"0.25\"/>"
                    + "<position x=\"1.0\" y=\"2.0\" z=\"-3.0\"/>"
                    + "<orientation w=\"1.0\" x=\"0.0\" y=\"0.0\" z=\"0.0\"/>"
                    + "<velocity x=\"4.0\" y=\"0.0\" z=\"0.0\"/>"
                    + "<angular-velocity x=\"0.0\" y=\"0.0\" z=\"0.0\"/></world-object>";

    private final TcpTransport tcp = TcpTransport.onLoopback(0);

    private static WorldObjectDefinition.Builder ball() {
        return WorldObjectDefinition.named("Ball")
                .id(7)
                .volume(new Sphere(0.25))
                .mass(2)
                .restitution(0.5)
                .position(1, 2, -3)
                .velocity(4, 0, 0);
    }

    private static WorldObjectDefinition floor(int rows, int columns, double height) {
        double[] heights = new double[columns];
        Arrays.fill(heights, height);
        HeightMap map =
                new HeightMap(1, Collections.nCopies(rows, new HeightMap.Row(Numbers.of(heights))));
        return WorldObjectDefinition.named("Floor")
                .id(3)
                .fixed()
                .volume(map)
                .position(0, 0, -50)
                .build();
    }

    private Simulator serving(WorldObjectDefinition object, Role role) {
        World world = World.builder().add(object).build();
        return Simulator.of(world).paused().role(role).transport(tcp).start();
    }

    private String asked(long id) throws IOException {
        try (RawClient client = RawClient.welcomed(tcp.port())) {
            return client.ask(
                    "q", "<describe-world-object-request world-object-id=\"%d\"/>".formatted(id));
        }
    }

    @Test
    void aViewerIsToldAnObjectAsAScenarioWouldStateIt() throws IOException {
        try (Simulator _ = serving(ball().build(), Role.VIEWER)) {
            assertThat(asked(7))
                    .isEqualTo(
                            "<auvsml request-id=\"q\"><world-object-description-response>"
                                    + BALL
                                    + "</world-object-description-response></auvsml>");
        }
    }

    @Test
    void itIsToldAsItIsNowAndMayBeReadBack() throws Exception {
        WorldObjectDefinition driven =
                ball().component(new Propulsor("Tail", 10, 0, Vec3.ZERO, new Vec3(1, 0, 0)))
                        .build();
        try (Simulator simulator = serving(driven, Role.ADMIN);
                AuvsmlClient client = AuvsmlClient.connect("127.0.0.1", tcp.port())) {
            client.send(ListenerRegistrationRequestCommand.ofAll("*"));
            client.send(new AddEffectCommand(7, new Gravity(1)));
            client.send(new StepCommand(2));
            awaitStep(client);
            awaitStep(client);
            client.send(new DescribeWorldObjectRequest(7));
            WorldObjectDefinition told = description(client);
            assertThat(told.position().x()).isCloseTo(1 + 4 * 0.1, within(1e-12));
            assertThat(told.velocity().z()).isCloseTo(-0.1, within(1e-12));
            assertThat(told.effect()).containsExactly(new Gravity(1));
            assertThat(told)
                    .isEqualTo(
                            simulator.<WorldObjectDefinition>ask(
                                    world -> world.object(7).presentDefinition()));
        }
    }

    private static void awaitStep(AuvsmlClient client) throws IOException {
        next(client, TimestepAdvancedNotification.class);
    }

    private static WorldObjectDefinition description(AuvsmlClient client) throws IOException {
        return next(client, WorldObjectDescriptionResponse.class).worldObject();
    }

    /** The next message of a type, which comes alone in its root; others are passed over. */
    private static <M extends Message> M next(AuvsmlClient client, Class<M> type)
            throws IOException {
        while (true) {
            for (Message message : client.next().orElseThrow().messages()) {
                if (type.isInstance(message)) {
                    return type.cast(message);
                }
            }
        }
    }

    @Test
    void anObjectThatIsNotThereIsRefused() throws IOException {
        try (Simulator _ = serving(ball().build(), Role.VIEWER)) {
            assertThat(asked(8))
                    .contains("code=\"UNKNOWN_ENTITY\"")
                    .contains("no world object has the id 8");
        }
    }

    @Test
    void aMapThatNoClientCouldTakeIsRefused() throws IOException {
        try (Simulator _ = serving(floor(500, 500, 1.25), Role.VIEWER)) {
            assertThat(asked(3))
                    .contains("code=\"REFUSED\"")
                    .containsPattern(
                            "the description of 'Floor' is too long for a message \\(it has"
                                    + " 12\\d{5} bytes, a message at most 983040\\); its scenario"
                                    + " has it");
        }
    }

    @Test
    void aRowThatNoClientCouldTakeIsRefused() throws IOException {
        try (Simulator _ = serving(floor(2, 1000, 1.25), Role.VIEWER)) {
            assertThat(asked(3))
                    .contains("code=\"REFUSED\"")
                    .contains(
                            "the description of 'Floor' is too long for a message (maximum"
                                    + " attribute size limit (4096) exceeded); its scenario has"
                                    + " it");
        }
    }

    @Test
    void aMapThatClientsTakeIsTold() throws Exception {
        try (Simulator _ = serving(floor(200, 500, 1.25), Role.VIEWER);
                AuvsmlClient client = AuvsmlClient.connect("127.0.0.1", tcp.port())) {
            client.send(new DescribeWorldObjectRequest(3));
            assertThat(description(client)).isEqualTo(floor(200, 500, 1.25));
        }
    }
}
