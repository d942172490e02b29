package org.auvsim.viz.source;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import static java.nio.charset.StandardCharsets.UTF_8;

import org.auvsim.auvsml.Role;
import org.auvsim.auvsml.client.ConnectionException;
import org.auvsim.auvsml.document.Scenario;
import org.auvsim.auvsml.mapping.MessageCatalogue;
import org.auvsim.auvsml.message.Message;
import org.auvsim.auvsml.message.control.ApplyDirectForceCommand;
import org.auvsim.auvsml.message.control.GetSimulatorStateRequest;
import org.auvsim.auvsml.message.control.LoadScenarioCommand;
import org.auvsim.auvsml.message.control.ResetCommand;
import org.auvsim.auvsml.message.control.SimulatorStateResponse;
import org.auvsim.auvsml.message.control.StepCommand;
import org.auvsim.auvsml.message.entity.AddWorldObjectCommand;
import org.auvsim.auvsml.message.entity.DescribeWorldObjectRequest;
import org.auvsim.auvsml.message.entity.RemoveEntityCommand;
import org.auvsim.auvsml.message.feedback.DifferentPositionFeedbackMessage;
import org.auvsim.core.entity.Behavior;
import org.auvsim.core.entity.Frame;
import org.auvsim.core.entity.WorldObject;
import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.core.field.UniformCurrent;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.volume.Sphere;
import org.auvsim.core.world.World;
import org.auvsim.server.feedback.AsynchronousFeedbackTimestepper;
import org.auvsim.server.feedback.FeedbackTimestepper;
import org.auvsim.server.feedback.SimpleFixedTimeFeedbackTimestepper;
import org.auvsim.server.net.TcpTransport;
import org.auvsim.server.simulator.Simulator;
import org.auvsim.viz.scene.ActorView;
import org.auvsim.viz.scene.Scene;
import org.auvsim.viz.scene.SeenObject;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.time.Duration;
import java.util.List;
import java.util.concurrent.ExecutionException;

/** Over real sockets. */
@Timeout(60)
class LiveSourceTest {
    private static final MessageCatalogue CATALOGUE =
            MessageCatalogue.load(LiveSourceTest.class.getClassLoader());

    private static WorldObjectDefinition ball(String name, int id, double vx) {
        return WorldObjectDefinition.named(name)
                .id(id)
                .mass(2)
                .volume(new Sphere(0.5))
                .position(id, 0, 0)
                .velocity(vx, 0, 0)
                .build();
    }

    private static World world() {
        return World.builder()
                .timeStep(0.1)
                .add(ball("Bob", 10, 1))
                .add(ball("Carl", 20, 0))
                .add(new UniformCurrent(100, "Tide", new Vec3(0.3, 0, 0)))
                .build();
    }

    private static Simulator serving(TcpTransport tcp, Role role) {
        return Simulator.of(world()).paused().role(role).transport(tcp).start();
    }

    private static LiveSource connected(int port) throws Exception {
        LiveSource source = LiveSource.connect("127.0.0.1", port, CATALOGUE);
        source.ready().get();
        return source;
    }

    /** What the simulator told before it answered is in the scene when this returns. */
    private static void makeSteps(LiveSource source, long until) throws Exception {
        source.ask(new StepCommand((int) until)).get();
        Message state = source.ask(new GetSimulatorStateRequest()).get();
        while (((SimulatorStateResponse) state).step() < until) {
            state = source.ask(new GetSimulatorStateRequest()).get();
        }
        source.ask(new GetSimulatorStateRequest()).get();
    }

    private static double x(Scene scene, long id) {
        scene.look(Long.MAX_VALUE / 2, _ -> {});
        return scene.motion(id).orElseThrow().position().x();
    }

    @Test
    void aViewerKnowsWhatThereIsWhenItIsReady() throws Exception {
        TcpTransport tcp = TcpTransport.onLoopback(0);
        try (Simulator _ = serving(tcp, Role.VIEWER);
                LiveSource source = connected(tcp.port())) {
            assertThat(source.scene().objects())
                    .extracting(SeenObject::name)
                    .containsExactly("Bob", "Carl");
            assertThat(source.scene().object(10).orElseThrow().definition().orElseThrow().volume())
                    .isEqualTo(new Sphere(0.5));
            source.scene().look(0, look -> assertThat(look.fields()).hasSize(1));
            assertThat(source.role()).isEqualTo(Role.VIEWER);
        }
    }

    @Test
    void objectsMoveAsTheSimulatorSays() throws Exception {
        TcpTransport tcp = TcpTransport.onLoopback(0);
        try (Simulator _ = serving(tcp, Role.ADMIN);
                LiveSource source = connected(tcp.port())) {
            makeSteps(source, 5);
            assertThat(x(source.scene(), 10)).isCloseTo(10.5, within(1e-12));
            assertThat(x(source.scene(), 20)).isEqualTo(20);
            assertThat(source.scene().motion(10).orElseThrow().velocity().x()).isEqualTo(1);
            assertThat(source.status()).contains("as admin");
        }
    }

    @Test
    void whatComesAndGoesIsSeen() throws Exception {
        TcpTransport tcp = TcpTransport.onLoopback(0);
        try (Simulator _ = serving(tcp, Role.ADMIN);
                LiveSource source = connected(tcp.port())) {
            source.ask(new AddWorldObjectCommand(ball("Dora", 30, 0))).get();
            source.ask(new RemoveEntityCommand(20)).get();
            makeSteps(source, 1);
            source.ask(new DescribeWorldObjectRequest(30)).get();
            assertThat(source.scene().objects())
                    .extracting(SeenObject::name)
                    .containsExactly("Bob", "Dora");
        }
    }

    @Test
    void afterAResetMovementsAreSeenAtOnce() throws Exception {
        TcpTransport tcp = TcpTransport.onLoopback(0);
        try (Simulator _ = serving(tcp, Role.ADMIN);
                LiveSource source = connected(tcp.port())) {
            makeSteps(source, 9);
            source.ask(new ResetCommand()).get();
            source.ask(new StepCommand(2)).get();
            while (Math.abs(x(source.scene(), 10) - 10.2) > 1e-9) {
                source.ask(new GetSimulatorStateRequest()).get();
            }
            assertThat(source.scene().time()).isCloseTo(0.2, within(1e-9));
        }
    }

    @Test
    void anotherScenarioReplacesAllThatWasThere() throws Exception {
        World other =
                World.builder()
                        .add(
                                WorldObjectDefinition.named("Rock")
                                        .id(10)
                                        .fixed()
                                        .volume(new Sphere(3))
                                        .position(-7, 0, 0)
                                        .build())
                        .build();
        TcpTransport tcp = TcpTransport.onLoopback(0);
        try (Simulator _ = serving(tcp, Role.ADMIN);
                LiveSource source = connected(tcp.port())) {
            long worlds = source.scene().worlds();
            source.ask(new LoadScenarioCommand(Scenario.of(other))).get();
            while (!source.scene().objects().stream()
                    .map(SeenObject::name)
                    .toList()
                    .equals(List.of("Rock"))) {
                source.ask(new GetSimulatorStateRequest()).get();
            }
            while (hasFields(source.scene())) {
                source.ask(new GetSimulatorStateRequest()).get();
            }
            while (source.scene().worlds() == worlds) {
                source.ask(new GetSimulatorStateRequest()).get();
            }
            assertThat(x(source.scene(), 10)).isEqualTo(-7);
        }
    }

    private static boolean hasFields(Scene scene) {
        boolean[] has = new boolean[1];
        scene.look(0, look -> has[0] = !look.fields().isEmpty());
        return has[0];
    }

    @Test
    void whoGoesAtOnceIsNoSimulatorToSee() throws Exception {
        String welcome =
                "<auvsml><welcome-message protocol-version=\"1\" server=\"x\" session-id=\"1\""
                        + " role=\"viewer\"/></auvsml>";
        try (ServerSocket socket = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
            Thread server =
                    Thread.startVirtualThread(
                            () -> {
                                try (Socket client = socket.accept()) {
                                    client.getOutputStream().write(welcome.getBytes(UTF_8));
                                } catch (IOException e) {
                                    throw new AssertionError(e);
                                }
                            });
            try (LiveSource source =
                    LiveSource.connect("127.0.0.1", socket.getLocalPort(), CATALOGUE)) {
                assertThatThrownBy(() -> source.ready().get())
                        .hasCauseInstanceOf(RefusedException.class)
                        .hasMessageContaining("The simulator at 127.0.0.1:");
            }
            server.join();
        }
    }

    @Test
    void aForceThatIsSetIsSeen() throws Exception {
        TcpTransport tcp = TcpTransport.onLoopback(0);
        try (Simulator _ = serving(tcp, Role.CONTROLLER);
                LiveSource source = connected(tcp.port())) {
            source.ask(new ApplyDirectForceCommand(10, "Viewer", Frame.WORLD, new Vec3(0, 3, 0)))
                    .get();
            source.ask(new DescribeWorldObjectRequest(10)).get();
            source.scene()
                    .look(
                            0,
                            look ->
                                    assertThat(look.actor(0).forces().getFirst().vector())
                                            .isEqualTo(new Vec3(0, 3, 0)));
        }
    }

    @Test
    void whereTheStepWillBringAnObjectIsSeen() throws Exception {
        TcpTransport tcp = TcpTransport.onLoopback(0);
        FeedbackTimestepper waiting =
                SimpleFixedTimeFeedbackTimestepper.waiting(Duration.ofMillis(1));
        try (Simulator _ = meeting(tcp, waiting);
                LiveSource source = connected(tcp.port())) {
            makeSteps(source, 2);
            source.scene()
                    .look(
                            Long.MAX_VALUE / 2,
                            look -> {
                                ActorView bob = look.actor(0);
                                assertThat(bob.isProjected()).isTrue();
                                assertThat(bob.projectedPosition(0)).isCloseTo(1.2, within(1e-12));
                            });
        }
    }

    /** The bound is crossed upwards and downwards while the simulator runs. */
    @Test
    void projectedStatesAreLeftOutWhileThereAreManyObjects() throws Exception {
        TcpTransport tcp = TcpTransport.onLoopback(0);
        FeedbackTimestepper waiting =
                SimpleFixedTimeFeedbackTimestepper.waiting(Duration.ofMillis(1));
        try (Simulator _ = meeting(tcp, waiting);
                LiveSource source = connected(tcp.port())) {
            for (int id = 1001; id < 1000 + Audience.MOST_PROJECTED; id++) {
                source.ask(new AddWorldObjectCommand(ball("B" + id, id, 0))).get();
            }
            told(source, "There are 201 objects: their projected states are left out");
            makeSteps(source, 2);
            assertThat(isProjected(source)).isFalse();
            source.ask(new RemoveEntityCommand(1001)).get();
            told(source, "There are 200 objects: their projected states are shown again");
            makeSteps(source, 4);
            assertThat(isProjected(source)).isTrue();
        }
    }

    /** Breaks as soon as time has passed. */
    private record Fault(String name) implements Behavior {
        @Override
        public void act(double time, WorldObject self) {
            throw new IllegalStateException("the rudder of '%s' broke".formatted(self.name()));
        }
    }

    @Test
    void whatGoesWrongThoughNobodyAskedIsTold() throws Exception {
        World world = world();
        world.object(10).add(new Fault("fault"));
        TcpTransport tcp = TcpTransport.onLoopback(0);
        try (Simulator _ = Simulator.of(world).paused().transport(tcp).start();
                LiveSource source = connected(tcp.port())) {
            source.ask(new StepCommand(1)).get();
            told(
                    source,
                    "The simulator says: the step at 0.0 s failed and the simulation is paused: the"
                            + " rudder of 'Bob' broke");
        }
    }

    /** Waits until something is told, and until what was asked for then is done. */
    private static void told(LiveSource source, String words) throws Exception {
        while (source.scene().drainOccurrences().stream().noneMatch(o -> o.text().equals(words))) {
            Thread.onSpinWait();
        }
        source.ask(new GetSimulatorStateRequest()).get();
    }

    /** Whether it is known where Bob's step will bring him. */
    private static boolean isProjected(LiveSource source) {
        source.scene().look(Long.MAX_VALUE / 2, _ -> {});
        return source.scene().lookAt(1, ActorView::isProjected).orElseThrow();
    }

    @Test
    void measurementsAndCollisionsAreSeen() throws Exception {
        TcpTransport tcp = TcpTransport.onLoopback(0);
        try (Simulator _ = meeting(tcp, new AsynchronousFeedbackTimestepper());
                LiveSource source = connected(tcp.port())) {
            Vec3 known = new Vec3(1, 0, 0);
            Vec3 measured = new Vec3(1.5, 0.25, 0);
            source.ask(
                            new DifferentPositionFeedbackMessage(
                                    1,
                                    0,
                                    "DirectPositionChangeFeedbackHandler",
                                    known,
                                    measured,
                                    known))
                    .get();
            makeSteps(source, 15);
            source.scene()
                    .look(
                            Long.MAX_VALUE / 2,
                            look -> {
                                ActorView bob = look.actor(0);
                                assertThat(bob.isMeasured()).isTrue();
                                assertThat(bob.measuredPosition(1)).isEqualTo(0.25);
                                assertThat(look.meetings()).hasSize(1);
                                assertThat(look.meetings().getFirst().one()).isIn(1L, 3L);
                            });
        }
    }

    /** Bob will meet Carl after a second. */
    private static Simulator meeting(TcpTransport tcp, FeedbackTimestepper timestepper) {
        World world =
                World.builder()
                        .timeStep(0.1)
                        .add(ball("Bob", 1, 1))
                        .add(ball("Carl", 3, 0))
                        .build();
        return Simulator.of(world)
                .timestepper(timestepper)
                .paused()
                .role(Role.ADMIN)
                .transport(tcp)
                .start();
    }

    @Test
    void whatTheRoleDoesNotAllowIsRefusedInWords() throws Exception {
        TcpTransport tcp = TcpTransport.onLoopback(0);
        try (Simulator _ = serving(tcp, Role.VIEWER);
                LiveSource source = connected(tcp.port())) {
            assertThatThrownBy(() -> source.ask(new StepCommand(1)).get())
                    .isInstanceOf(ExecutionException.class)
                    .cause()
                    .isInstanceOf(RefusedException.class)
                    .hasMessageContaining("admin");
        }
    }

    @Test
    void aSimulatorThatComesBackIsConnectedToAgain() throws Exception {
        TcpTransport tcp = TcpTransport.onLoopback(0);
        Simulator first = serving(tcp, Role.ADMIN);
        int port = tcp.port();
        try (LiveSource source = connected(port)) {
            first.close();
            while (source.isConnected()) {
                Thread.onSpinWait();
            }
            assertThat(source.status()).contains("127.0.0.1:" + port).endsWith("Trying again ...");
            assertThat(source.role()).isEqualTo(Role.VIEWER);
            assertThatThrownBy(() -> source.ask(new StepCommand(1)).get())
                    .hasCauseInstanceOf(RefusedException.class);
            try (Simulator _ = serving(TcpTransport.onLoopback(port), Role.CONTROLLER)) {
                while (source.role() != Role.CONTROLLER || source.scene().objects().size() < 2) {
                    Thread.onSpinWait();
                }
                assertThat(source.status()).contains("as controller");
            }
        }
    }

    @Test
    void nobodyThereIsSaidAtOnce() throws IOException {
        int free;
        try (ServerSocket socket = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
            free = socket.getLocalPort();
        }
        assertThatThrownBy(() -> LiveSource.connect("127.0.0.1", free, CATALOGUE))
                .isInstanceOf(ConnectionException.class)
                .hasMessageContaining("Nobody listens at 127.0.0.1:" + free);
    }
}
