package org.auvsim.examples.client;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.auvsml.client.AuvsmlClient;
import org.auvsim.auvsml.document.ScenarioLoader;
import org.auvsim.auvsml.message.movement.KinematicStateMessage;
import org.auvsim.core.actuator.Fin;
import org.auvsim.core.entity.Twist;
import org.auvsim.core.entity.WorldObject;
import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.world.World;
import org.auvsim.server.net.TcpTransport;
import org.auvsim.server.simulator.Simulator;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

import java.nio.file.Path;
import java.util.List;
import java.util.OptionalDouble;

/** The autopilot flies the world of its scenario, here without a network between. */
@Timeout(60)
class AutopilotTest {
    private World world() throws Exception {
        return ScenarioLoader.load(getClass().getClassLoader())
                .load(Path.of("scenarios/remus-survey.xml"))
                .world();
    }

    @Test
    void itReachesItsWaypointsAtTheirDepths() throws Exception {
        World world = world();
        WorldObject torpedo = world.object(1);
        Autopilot pilot = new Autopilot(Autopilot.WAYPOINTS);
        double worst = 0;
        while (pilot.left() > 0 && world.time() < 300) {
            world.advanceTimestep();
            int before = pilot.left();
            pilot.answer(stateOf(world.time(), torpedo))
                    .forEach(turn -> torpedo.command(Fin.class, turn.name(), turn.angle()));
            if (pilot.left() < before) {
                double height = Autopilot.WAYPOINTS.get(4 - before).z();
                worst = Math.max(worst, Math.abs(torpedo.position().z() - height));
            }
        }
        assertThat(pilot.left()).isZero();
        assertThat(worst).isLessThan(2);
    }

    @Test
    void itFliesOverASocket() throws Exception {
        TcpTransport tcp = TcpTransport.onLoopback(0);
        try (Simulator _ =
                        Simulator.of(world()).rate(OptionalDouble.of(20)).transport(tcp).start();
                AuvsmlClient client = AuvsmlClient.connect("127.0.0.1", tcp.port())) {
            assertThat(new Autopilot(List.of(new Vec3(15, 3, -20))).fly(client)).isTrue();
        }
    }

    private static KinematicStateMessage stateOf(double time, WorldObject object) {
        Twist twist = object.twist();
        Quat turn = object.orientation();
        return new KinematicStateMessage(
                time,
                object.id(),
                object.position(),
                turn,
                twist.velocity(),
                twist.angularVelocity(),
                turn.rotateInverse(twist.velocity()),
                turn.rotateInverse(twist.angularVelocity()));
    }
}
