package org.auvsim.cli.demo;

import org.auvsim.auvsml.client.AuvsmlClient;
import org.auvsim.auvsml.message.control.ShutdownSimulatorCommand;
import org.auvsim.server.net.TcpTransport;
import org.auvsim.server.net.TransportException;
import org.auvsim.server.simulator.Simulator;
import org.auvsim.server.simulator.SimulatorBuilder;

import java.io.IOException;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.ToDoubleFunction;

/** One flight: a server on a free loopback port, and the physical robot as its client. */
final class Flight {
    private final SimulatorBuilder server;
    private final FlightPlan plan;
    private final Optional<Sensors> sensors;
    private final Track track;
    private final LiveTable table;

    /**
     * A flight that is still to begin.
     *
     * @param server what the robot's simulated self lives in; it gets its port and its rate here
     * @param sensors what the robot measures; empty: it sends no feedback
     */
    Flight(
            SimulatorBuilder server,
            FlightPlan plan,
            Optional<Sensors> sensors,
            Track track,
            LiveTable table) {
        this.server = server;
        this.plan = plan;
        this.sensors = sensors;
        this.track = track;
        this.table = table;
    }

    /**
     * Flies the plan.
     *
     * @param until a world time (s), which may change as the flight goes on
     * @return the robot, which knows how it went
     */
    PhysicalRobot fly(ToDoubleFunction<PhysicalRobot> until)
            throws IOException, TransportException {
        TcpTransport transport = TcpTransport.onLoopback(0);
        server.transport(transport).rate(OptionalDouble.empty()).paused();
        try (Simulator _ = server.start();
                AuvsmlClient link = AuvsmlClient.connect("127.0.0.1", transport.port())) {
            PhysicalRobot robot =
                    new PhysicalRobot(
                            link,
                            new Pilot(link, plan),
                            new TrueRobot(plan),
                            sensors,
                            track,
                            table);
            robot.prepare();
            robot.live(() -> until.applyAsDouble(robot));
            link.send(new ShutdownSimulatorCommand());
            return robot;
        }
    }
}
