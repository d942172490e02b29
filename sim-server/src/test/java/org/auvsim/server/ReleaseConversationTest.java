package org.auvsim.server;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.auvsim.auvsml.document.ReleasedForces;
import org.auvsim.auvsml.document.ReleasedObject;
import org.auvsim.core.actuator.Propulsor;
import org.auvsim.core.effect.Damping;
import org.auvsim.core.entity.Frame;
import org.auvsim.core.entity.NamedForce;
import org.auvsim.core.entity.WorldObject;
import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.volume.Sphere;
import org.auvsim.core.world.World;
import org.auvsim.server.net.TcpTransport;
import org.auvsim.server.simulator.Simulator;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.EnumSource.Mode;
import org.junit.jupiter.params.provider.ValueSource;

import java.io.IOException;
import java.util.function.Function;

/** What becomes of a vehicle whose pilot lets go, or goes, over real sockets. */
@Timeout(60)
class ReleaseConversationTest {
    private static final NamedForce LIFT =
            NamedForce.direct("lift", Frame.WORLD, new Vec3(0, 0, 0.25));
    private static final Damping WATER =
            new Damping(new Vec3(1, 1, 1), Vec3.ZERO, Vec3.ZERO, Vec3.ZERO);

    private final TcpTransport tcp = TcpTransport.onLoopback(0);

    private static World world() {
        return World.builder()
                .add(
                        WorldObjectDefinition.named("Vehicle")
                                .id(1)
                                .mass(2)
                                .volume(new Sphere(1))
                                .velocity(3, 0, 0)
                                .angularVelocity(0, 0, 1)
                                .force(LIFT)
                                .effect(WATER)
                                .component(
                                        new Propulsor("Tail", 10, 0, Vec3.ZERO, new Vec3(1, 0, 0)))
                                .build())
                .build();
    }

    private Simulator simulator(ReleasedForces forces) {
        return Simulator.of(world())
                .releasedObject(new ReleasedObject(forces, 0.5, 0.5))
                .transport(tcp)
                .paused()
                .start();
    }

    private static void fly(RawClient pilot) throws IOException {
        pilot.ask(
                "1",
                "<apply-direct-force-command world-object-id=\"1\" name=\"tow\""
                        + " orientation=\"BODY\"><force-vector x=\"0\" y=\"1\""
                        + " z=\"0\"/></apply-direct-force-command>");
        pilot.ask(
                "2", "<set-propulsor-command world-object-id=\"1\" name=\"Tail\" level=\"0.5\"/>");
    }

    private static void letGo(RawClient pilot, boolean byCommand) throws IOException {
        if (byCommand) {
            pilot.ask("3", "<release-control-command world-object-id=\"1\"/>");
        } else {
            pilot.endOutput();
            pilot.rest();
        }
    }

    private static <T> T vehicle(Simulator simulator, Function<WorldObject, T> question) {
        return simulator.ask(world -> question.apply(world.object(1)));
    }

    private static double level(Simulator simulator) {
        return vehicle(simulator, v -> v.component(Propulsor.class).orElseThrow().command());
    }

    private static void advance(Simulator simulator, int steps) {
        for (int i = 0; i < steps; i++) {
            simulator.advanceTimestep();
        }
    }

    @ParameterizedTest
    @ValueSource(booleans = {true, false})
    void allGoesOnWhereItIsKept(boolean byCommand) throws IOException {
        try (Simulator simulator = simulator(ReleasedForces.KEEP);
                RawClient pilot = RawClient.welcomed(tcp.port())) {
            fly(pilot);
            letGo(pilot, byCommand);
            assertThat(level(simulator)).isEqualTo(0.5);
            assertThat(vehicle(simulator, WorldObject::forces)).hasSize(2);
            assertThat(vehicle(simulator, WorldObject::effects)).containsExactly(WATER);
        }
    }

    @ParameterizedTest
    @EnumSource(names = "KEEP", mode = Mode.EXCLUDE)
    void forcesAreThoseOfTheScenarioAgainAndPropulsorsStandStill(ReleasedForces forces)
            throws IOException {
        try (Simulator simulator = simulator(forces);
                RawClient pilot = RawClient.welcomed(tcp.port())) {
            fly(pilot);
            letGo(pilot, false);
            assertThat(level(simulator)).isZero();
            assertThat(vehicle(simulator, WorldObject::forces)).containsExactly(LIFT);
        }
    }

    @ParameterizedTest
    @ValueSource(booleans = {true, false})
    void aVehicleThatBrakesComesToRestUntilItIsTakenAgain(boolean byCommand) throws IOException {
        try (Simulator simulator = simulator(ReleasedForces.BRAKE);
                RawClient pilot = RawClient.welcomed(tcp.port());
                RawClient other = RawClient.welcomed(tcp.port())) {
            fly(pilot);
            advance(simulator, 20);
            letGo(pilot, byCommand);
            advance(simulator, 200);
            // The lift of the scenario goes on: the brake and the water hold it at a creep.
            assertThat(vehicle(simulator, WorldObject::velocity))
                    .satisfies(
                            v -> assertThat(v.x()).isCloseTo(0, within(1e-6)),
                            v -> assertThat(v.y()).isCloseTo(0, within(1e-6)),
                            v -> assertThat(v.z()).isCloseTo(0.25 / (20 + 1), within(1e-6)));
            assertThat(
                            ReleaseConversationTest.<Double>vehicle(
                                    simulator, v -> v.angularVelocity().norm()))
                    .isCloseTo(0, within(1e-6));
            other.ask("1", "<take-control-command world-object-id=\"1\"/>");
            assertThat(vehicle(simulator, WorldObject::effects)).containsExactly(WATER);
        }
    }

    @ParameterizedTest
    @EnumSource
    void aSnapshotOfAReleasedVehicleGoesOnAsItDid(ReleasedForces forces) throws IOException {
        try (Simulator simulator = simulator(forces);
                RawClient pilot = RawClient.welcomed(tcp.port());
                RawClient admin = RawClient.welcomed(tcp.port())) {
            fly(pilot);
            advance(simulator, 5);
            letGo(pilot, true);
            admin.ask("1", "<take-snapshot-command name=\"adrift\"/>");
            advance(simulator, 10);
            long hash = simulator.ask(World::stateHash);
            admin.ask("2", "<restore-snapshot-command name=\"adrift\"/>");
            advance(simulator, 10);
            assertThat(simulator.<Long>ask(World::stateHash)).isEqualTo(hash);
            pilot.ask("4", "<take-control-command world-object-id=\"1\"/>");
            assertThat(vehicle(simulator, WorldObject::effects)).containsExactly(WATER);
        }
    }
}
