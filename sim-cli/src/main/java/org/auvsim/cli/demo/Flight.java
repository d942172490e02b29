package org.auvsim.cli.demo;

import org.auvsim.auvsml.client.AuvsmlClient;
import org.auvsim.auvsml.document.Scenario;
import org.auvsim.auvsml.message.control.ShutdownSimulatorCommand;
import org.auvsim.server.net.TcpTransport;
import org.auvsim.server.net.TransportException;
import org.auvsim.server.simulator.Simulator;

import java.io.IOException;
import java.util.Optional;
import java.util.OptionalDouble;

/** One flight: a server on a free loopback port, and the physical robot as its client. */
final class Flight {
    private final Scenario scenario;
    private final Optional<Sensors> sensors;
    private final Track track;
    private final LiveTable table;
    private final double duration;
    private final FlightPlan plan = new FlightPlan();

    /**
     * A flight that is still to begin.
     *
     * @param sensors what the robot measures; empty: it sends no feedback
     * @param duration how much of the plan is flown (s)
     */
    Flight(
            Scenario scenario,
            Optional<Sensors> sensors,
            Track track,
            LiveTable table,
            double duration) {
        this.scenario = scenario;
        this.sensors = sensors;
        this.track = track;
        this.table = table;
        this.duration = duration;
    }

    private Simulator serve(TcpTransport transport) throws TransportException {
        return Simulator.of(scenario)
                .transport(transport)
                .rate(OptionalDouble.empty())
                .paused()
                .start();
    }

    /** Flies the plan; returns how many corrections the server refused. */
    int fly() throws IOException, TransportException {
        TcpTransport transport = TcpTransport.onLoopback(0);
        try (Simulator _ = serve(transport);
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
            robot.live(duration);
            link.send(new ShutdownSimulatorCommand());
            return robot.refused();
        }
    }
}
