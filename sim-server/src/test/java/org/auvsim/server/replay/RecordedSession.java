package org.auvsim.server.replay;

import org.auvsim.auvsml.document.Scenario;
import org.auvsim.server.RawClient;
import org.auvsim.server.net.TcpTransport;
import org.auvsim.server.simulator.Simulator;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.util.OptionalDouble;

/** A paused simulator that is recorded, and a client of it. */
final class RecordedSession implements AutoCloseable {
    private final ByteArrayOutputStream file = new ByteArrayOutputStream();
    private final Recorder recorder;
    private final Simulator simulator;
    private final RawClient client;

    RecordedSession(Scenario scenario) throws IOException {
        TcpTransport tcp = TcpTransport.onLoopback(0);
        recorder = Recorded.recorder(file, scenario);
        simulator =
                Simulator.of(scenario)
                        .transport(tcp)
                        .rate(OptionalDouble.empty())
                        .paused()
                        .log(recorder)
                        .start();
        client = RawClient.welcomed(tcp.port());
    }

    Simulator simulator() {
        return simulator;
    }

    RawClient client() {
        return client;
    }

    /** Makes steps that wait for nobody. */
    void steps(int count) {
        for (int i = 0; i < count; i++) {
            simulator.advanceTimestep();
        }
    }

    void push(double x) throws IOException {
        client.ask("push", pushing(x));
    }

    /** The command that pushes the robot. */
    static String pushing(double x) {
        return ("<apply-direct-force-command world-object-id='1' name='engine' orientation='WORLD'>"
                        + "<force-vector x='%s' y='0' z='0'/></apply-direct-force-command>")
                .formatted(x);
    }

    /** Tells where the robot was at a time (s), which the simulator may refuse. */
    String correct(double time, double x) throws IOException {
        return client.ask(
                "correct",
                ("<different-position-feedback-message world-object-id='1' timestamp='%s'"
                                + " handler-name='DirectPositionChangeFeedbackHandler'>"
                                + "<virtual-position x='0' y='0' z='0'/>"
                                + "<actual-position x='%s' y='0' z='0'/>"
                                + "<old-position x='0' y='0' z='0'/>"
                                + "</different-position-feedback-message>")
                        .formatted(time, x));
    }

    /** Ends the simulation, and returns its recording. */
    byte[] recording() throws IOException {
        close();
        return file.toByteArray();
    }

    @Override
    public void close() throws IOException {
        simulator.close();
        recorder.close();
        client.close();
    }
}
