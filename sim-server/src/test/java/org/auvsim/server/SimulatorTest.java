package org.auvsim.server;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import org.auvsim.auvsml.message.command.RefusedException;
import org.auvsim.core.entity.Behavior;
import org.auvsim.core.entity.Frame;
import org.auvsim.core.entity.NamedForce;
import org.auvsim.core.entity.WorldObject;
import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.volume.Sphere;
import org.auvsim.core.world.World;
import org.auvsim.server.net.TcpTransport;
import org.auvsim.server.simulator.Simulator;
import org.auvsim.server.simulator.SimulatorBuilder;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;

/** What a running simulator does for its clients, over real sockets. */
@Timeout(60)
class SimulatorTest {
    private static final String STATE = "<get-simulator-state-request/>";

    private final TcpTransport tcp = TcpTransport.onLoopback(0);
    private final List<AutoCloseable> open = new ArrayList<>();

    private Simulator start(SimulatorBuilder builder) {
        Simulator simulator = builder.transport(tcp).rate(OptionalDouble.empty()).start();
        open.add(simulator);
        return simulator;
    }

    private RawClient client() throws IOException {
        RawClient client = RawClient.welcomed(tcp.port());
        open.add(client);
        return client;
    }

    @AfterEach
    void closeAll() throws Exception {
        for (AutoCloseable one : open.reversed()) {
            one.close();
        }
    }

    private static String listen(String id, String type) {
        return "<listener-registration-request-command register=\"1\"><world-object id=\""
                + id
                + "\"><listener type=\""
                + type
                + "\"/></world-object></listener-registration-request-command>";
    }

    private static String push(long id, String name, double x) {
        return "<apply-direct-force-command world-object-id=\""
                + id
                + "\" name=\""
                + name
                + "\" orientation=\"WORLD\"><force-vector x=\""
                + x
                + "\" y=\"0.0\" z=\"0.0\"/></apply-direct-force-command>";
    }

    @Test
    void theFirstMessageIsTheWelcome() throws IOException {
        start(Simulator.of(Tank.world()).serverName("auvsim 0.1.0"));
        try (RawClient client = new RawClient(tcp.port())) {
            assertThat(client.next())
                    .isEqualTo(
                            "<auvsml><welcome-message protocol-version=\"1\" server=\"auvsim"
                                    + " 0.1.0\" session-id=\"1\" role=\"admin\"/></auvsml>");
        }
    }

    @Test
    void aForceMovesTheWorldUntilItIsRemoved() throws IOException {
        Simulator simulator = start(Simulator.of(Tank.world()).paused());
        RawClient client = client();
        client.ask("r", listen("1", "*ALL*"));
        client.send("<auvsml>" + push(1, "Engine Thrust", 4) + "<step-command/></auvsml>");
        String moved = client.next("movement-state-change-message");
        // 4 N on 2 kg for 0.05 s
        assertThat(RawClient.number(moved, "linear-momentum", "x")).isCloseTo(0.2, within(1e-12));
        assertThat(RawClient.number(moved, "position", "x")).isCloseTo(0.0025, within(1e-12));
        assertThat(
                        client.ask(
                                "2",
                                "<remove-force-command world-object-id=\"1\" force-name=\"Engine"
                                        + " Thrust\"/>"))
                .isEqualTo("<auvsml request-id=\"2\"><command-done-response/></auvsml>");
        client.send("<auvsml><step-command/></auvsml>");
        moved = client.next("movement-state-change-message");
        assertThat(RawClient.number(moved, "linear-momentum", "x")).isCloseTo(0.2, within(1e-12));
        assertThat(simulator.<Integer>ask(w -> w.object(1).forces().size())).isZero();
    }

    @Test
    void messagesOfAStepComeInOrder() throws IOException {
        World world =
                World.builder()
                        .add(ball(1, -1.01, 1))
                        .add(ball(2, 1.01, -1))
                        .add(ball(3, 50, 0))
                        .add(ball(4, 48 - 0.04, 1))
                        .build();
        start(Simulator.of(world).paused());
        RawClient client = client();
        client.ask("r", listen("*", "*ALL*"));
        client.send("<auvsml><step-command/></auvsml>");
        List<String> step = new ArrayList<>();
        do {
            step.add(client.next());
        } while (!step.getLast().contains("timestep-advanced-notification"));
        assertThat(step.stream().map(SimulatorTest::element))
                .containsExactly(
                        "collision-notification",
                        "collision-notification",
                        "movement-state-change-message",
                        "kinematic-state-message",
                        "movement-state-change-message",
                        "kinematic-state-message",
                        "movement-state-change-message",
                        "kinematic-state-message",
                        "movement-state-change-message",
                        "kinematic-state-message",
                        "timestep-advanced-notification");
        // Each collision has its own time within the step, and all movements that of its end.
        assertThat(timestamp(step.get(0))).isCloseTo(0.01, within(1e-9));
        assertThat(timestamp(step.get(1))).isCloseTo(0.04, within(1e-9));
        assertThat(step.subList(2, 11)).allSatisfy(m -> assertThat(timestamp(m)).isEqualTo(0.05));
    }

    private static WorldObjectDefinition ball(long id, double x, double vx) {
        return WorldObjectDefinition.named("ball " + id)
                .id(id)
                .mass(2)
                .volume(new Sphere(1))
                .position(x, 0, 0)
                .velocity(vx, 0, 0)
                .build();
    }

    private static double timestamp(String root) {
        return Double.parseDouble(RawClient.attribute(root, "timestamp"));
    }

    private static String element(String root) {
        return root.replaceFirst("<auvsml[^>]*><([a-z-]+).*\\s*", "$1");
    }

    @Test
    void pauseStandsStillAndResumeGoesOn() throws IOException {
        start(Simulator.of(Tank.world()));
        RawClient client = client();
        client.ask("1", "<pause-simulator-command/>");
        String paused = client.ask("2", STATE);
        assertThat(RawClient.attribute(paused, "running")).isEqualTo("0");
        assertThat(RawClient.attribute(client.ask("3", STATE), "time"))
                .isEqualTo(RawClient.attribute(paused, "time"));
        client.ask("4", listen("1", "TimestepAdvanced"));
        client.send("<auvsml><resume-simulator-command/></auvsml>");
        double next =
                RawClient.number(
                        client.next("timestep-advanced"), "timestep-advanced", "timestamp");
        assertThat(next)
                .isCloseTo(
                        Double.parseDouble(RawClient.attribute(paused, "time")) + 0.05,
                        within(1e-9));
    }

    private static final String MOST_STEPS = "<step-command count=\"" + Integer.MAX_VALUE + "\"/>";

    @Test
    void pauseCallsOffTheStepsThatAreLeft() throws IOException {
        start(Simulator.of(Tank.world()).paused());
        RawClient client = client();
        client.ask("1", MOST_STEPS + "<pause-simulator-command/>");
        assertThat(RawClient.attribute(client.ask("2", STATE), "step")).isEqualTo("0");
    }

    @Test
    void resumeCallsOffTheStepsThatAreLeftAndHoldsTheRate() throws IOException {
        Simulator simulator = start(Simulator.of(Tank.world()).paused());
        simulator.setRate(OptionalDouble.of(1e-6));
        RawClient client = client();
        client.ask("1", MOST_STEPS + "<resume-simulator-command/>");
        client.ask("2", STATE);
        assertThat(RawClient.attribute(client.ask("3", STATE), "step")).isEqualTo("1");
    }

    @Test
    void stepsAskedForTwiceAreMoreStepsNotFewer() throws IOException {
        start(Simulator.of(Tank.world()).paused());
        RawClient client = client();
        client.ask("1", listen("1", "TimestepAdvanced"));
        client.ask("2", MOST_STEPS + MOST_STEPS);
        client.next("timestep-advanced-notification");
        client.next("timestep-advanced-notification");
        client.ask("3", "<pause-simulator-command/>");
    }

    @Test
    void shutdownEndsAllSessionsWithAReason() throws IOException {
        Simulator simulator = start(Simulator.of(Tank.world()));
        RawClient one = client();
        RawClient other = client();
        one.send("<auvsml><shutdown-simulator-command/></auvsml>");
        String farewell =
                "<disconnected-notification reason=\"the simulation has ended\"/></auvsml>\n";
        assertThat(one.rest()).endsWith(farewell);
        assertThat(other.rest()).endsWith(farewell);
        simulator.await();
    }

    @Test
    void theSimulationEndsAtItsTime() {
        Simulator simulator = start(Simulator.of(Tank.world()).until(OptionalDouble.of(2)));
        simulator.await();
        assertThat(simulator.<Double>ask(World::time)).isCloseTo(2, within(1e-9));
    }

    @Test
    void sameInputsGiveTheSameState() {
        List<Long> hashes = new ArrayList<>();
        for (int run = 0; run < 2; run++) {
            World world = World.builder().add(ball(1, -2, 1)).add(ball(2, 2, -1.5)).build();
            try (Simulator simulator =
                    Simulator.of(world)
                            .rate(OptionalDouble.empty())
                            .paused()
                            .until(OptionalDouble.of(10))
                            .start()) {
                simulator.ask(
                        w -> {
                            w.object(1)
                                    .applyForce(
                                            NamedForce.direct(
                                                    "f", Frame.BODY, new Vec3(1, 0.1, 0)));
                            return true;
                        });
                simulator.resume();
                simulator.await();
                hashes.add(simulator.ask(World::stateHash));
            }
        }
        assertThat(hashes.getFirst()).isEqualTo(hashes.getLast());
        World alone = World.builder().add(ball(1, -2, 1)).add(ball(2, 2, -1.5)).build();
        alone.object(1).applyForce(NamedForce.direct("f", Frame.BODY, new Vec3(1, 0.1, 0)));
        while (alone.time() < 10 - 1e-9) {
            alone.advanceTimestep();
        }
        assertThat(hashes.getFirst()).isEqualTo(alone.stateHash());
    }

    @Test
    void twoClientsHearTheSame() throws IOException {
        start(Simulator.of(Tank.world()).paused());
        RawClient one = client();
        RawClient other = client();
        one.ask("r", listen("*", "MovementStateChange"));
        other.ask("r", listen("*", "MovementStateChange"));
        one.send("<auvsml><step-command count=\"2\"/></auvsml>");
        for (int i = 0; i < 8; i++) {
            assertThat(one.next())
                    .contains("movement-state-change-message")
                    .isEqualTo(other.next());
        }
    }

    @Test
    void theFirstToCommandAnObjectControlsItUntilItGoes() throws IOException {
        start(Simulator.of(Tank.world()));
        RawClient first = client();
        RawClient second = client();
        first.ask("1", push(1, "f", 1));
        assertThat(second.ask("1", push(1, "f", 2)))
                .contains("code=\"NOT_IN_CONTROL\"")
                .contains("client 1 (127.0.0.1:")
                .contains(") controls 'Bob' (id 1); wait until it lets go");
        first.endOutput();
        first.rest();
        assertThat(second.ask("2", push(1, "f", 2))).contains("command-done-response");
        assertThat(second.ask("3", "<release-control-command world-object-id=\"1\"/>"))
                .contains("command-done-response");
    }

    @Test
    void aRefusedCommandTakesNoControl() throws IOException {
        start(Simulator.of(Tank.world()));
        RawClient first = client();
        RawClient second = client();
        assertThat(
                        first.ask(
                                "1",
                                "<remove-force-command world-object-id=\"1\""
                                        + " force-name=\"none\"/>"))
                .contains("UNKNOWN_ENTITY");
        assertThat(second.ask("1", push(1, "f", 2))).contains("command-done-response");
    }

    @Test
    void whoListensToAllHearsOfNewObjects() throws IOException {
        start(Simulator.of(Tank.world()).paused());
        RawClient client = client();
        client.ask("r", listen("*", "EntityAdded"));
        client.send(
                "<auvsml><add-world-object-command><world-object name=\"Rock\" mass=\"3.0\">"
                        + "<sphere radius=\"1.0\"/><position x=\"14.0\" y=\"-89.0\" z=\"22.0\"/>"
                        + "</world-object></add-world-object-command></auvsml>");
        assertThat(client.next("entity-added-message"))
                .isEqualTo(
                        "<auvsml><entity-added-message timestamp=\"0.0\""
                                + " entity-id=\"5\"/></auvsml>");
        assertThat(client.next())
                .isEqualTo(
                        "<auvsml><world-object-added-message timestamp=\"0.0\" entity-id=\"5\">"
                                + "<position x=\"14.0\" y=\"-89.0\" z=\"22.0\"/>"
                                + "</world-object-added-message></auvsml>");
        assertThat(client.next()).contains("<add-world-object-response world-object-id=\"5\"/>");
    }

    /** Fails once, one second into the simulation. */
    private record Fault(String name) implements Behavior {
        @Override
        public void act(double time, WorldObject self) {
            if (time > 0.99 && time < 1.01) {
                throw new IllegalStateException("the rudder of '" + self.name() + "' broke");
            }
        }
    }

    @Test
    void aStepThatFailsPausesAndIsToldAndTheServerGoesOn() throws IOException {
        World world = Tank.world();
        world.object(1).add(new Fault("fault"));
        start(Simulator.of(world).paused());
        RawClient one = client();
        RawClient other = client();
        one.send("<auvsml><resume-simulator-command/></auvsml>");
        assertThat(other.next("error-response"))
                .contains("code=\"STEP_FAILED\"")
                .contains("the simulation is paused: the rudder of 'Bob' broke");
        assertThat(one.next("error-response")).contains("STEP_FAILED");
        assertThat(RawClient.attribute(one.ask("2", STATE), "running")).isEqualTo("0");
    }

    @Test
    void stepsCanBeMadeByHandWhilePausedAlone() {
        Simulator simulator = start(Simulator.of(Tank.world()).paused());
        simulator.advanceTimestep();
        simulator.advanceTimestep();
        assertThat(simulator.state().time()).isEqualTo(0.1);
        assertThat(simulator.state().step()).isEqualTo(2);
        simulator.resume();
        assertThatThrownBy(simulator::advanceTimestep)
                .isInstanceOf(RefusedException.class)
                .hasMessageContaining("pause first");
    }

    @Test
    void disconnectSendsWhatIsOnItsWayAndEnds() throws IOException {
        start(Simulator.of(Tank.world()).paused());
        RawClient client = client();
        client.send("<auvsml><get-world-object-list-command/><disconnect-command/></auvsml>");
        assertThat(client.rest()).contains("</world-object-list-response>");
    }
}
