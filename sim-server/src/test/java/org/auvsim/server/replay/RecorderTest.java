package org.auvsim.server.replay;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.auvsml.document.Scenario;
import org.auvsim.auvsml.document.recording.SmallDisk;
import org.auvsim.auvsml.message.session.RecordingEndedNotification;
import org.auvsim.auvsml.recording.Entry;
import org.auvsim.auvsml.recording.RecordingEnded;
import org.auvsim.server.RawClient;
import org.auvsim.server.net.TcpTransport;
import org.auvsim.server.simulator.Simulator;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.util.List;
import java.util.OptionalDouble;
import java.util.concurrent.CountDownLatch;

@Timeout(60)
class RecorderTest {
    private final Scenario scenario = Recorded.scenario("<no-feedback-timestepper/>");

    @Test
    void whenTheDiskIsFullClientsAreToldAndTheSimulationGoesOn() throws Exception {
        ByteArrayOutputStream file = new ByteArrayOutputStream();
        String told = toldWhileRunning(new SmallDisk(file, 20_000));

        assertThat(told)
                .isEqualTo(
                        "<auvsml><recording-ended-notification reason=\"it cannot be written: No"
                                + " space left on device\"/></auvsml>");
        assertThat(file.size()).isEqualTo(20_000);
        try (Replayer replayer = Recorded.replayer(file.toByteArray())) {
            while (replayer.advanceTimestep()) {
                assertThat(replayer.divergence()).isEmpty();
            }
            assertThat(replayer.divergence()).isEmpty();
            assertThat(replayer.reach().isWhole()).isFalse();
        }
    }

    @Test
    void whenTheDiskStandsStillClientsAreToldAndTheSimulationGoesOn() throws Exception {
        ByteArrayOutputStream file = new ByteArrayOutputStream();
        try (StuckDisk disk = new StuckDisk(file)) {
            String told = toldWhileRunning(disk);

            assertThat(told).contains("the file takes entries too slowly");
        }
        List<Entry> entries = Recorded.entries(file.toByteArray());
        assertThat(entries).last().isInstanceOf(RecordingEnded.class);
        assertThat(((RecordingEnded) entries.getLast()).reason()).contains("too slowly");
    }

    @Test
    void oneThatIsWholeTellsNoFailure() throws Exception {
        Recorder recorder = Recorded.recorder(new ByteArrayOutputStream(), scenario);
        recorder.close();

        assertThat(recorder.failure()).isEmpty();
    }

    @Test
    void whatCannotBeWrittenAtTheEndIsAFailureToo() throws Exception {
        ByteArrayOutputStream begun = new ByteArrayOutputStream();
        Recorded.recorder(begun, scenario).close();
        SmallDisk disk = new SmallDisk(new ByteArrayOutputStream(), begun.size() - 1);
        Recorder recorder = Recorded.recorder(disk, scenario);
        recorder.close();

        assertThat(recorder.failure()).hasValue("it cannot be written: No space left on device");
    }

    /** Runs as fast as it can; what a client hears of the recording's end, steps later. */
    private String toldWhileRunning(OutputStream disk) throws Exception {
        TcpTransport tcp = TcpTransport.onLoopback(0);
        Recorder recorder = Recorded.recorder(disk, scenario);
        try (Simulator simulator =
                        Simulator.of(scenario)
                                .transport(tcp)
                                .rate(OptionalDouble.empty())
                                .paused()
                                .log(recorder)
                                .start();
                RawClient client = RawClient.welcomed(tcp.port())) {
            recorder.whenEnded(reason -> simulator.tell(new RecordingEndedNotification(reason)));
            simulator.resume();
            String told = client.next("recording-ended-notification");
            long step = simulator.state().step();
            simulator.pause();
            simulator.advanceTimestep();
            assertThat(simulator.state().step()).isGreaterThan(step);
            return told;
        } finally {
            disk.close();
            recorder.close();
            assertThat(recorder.failure()).isPresent();
        }
    }

    /** A disk that takes the beginning, and the rest only when it is closed. */
    private static final class StuckDisk extends OutputStream {
        private final OutputStream out;
        private final CountDownLatch freed = new CountDownLatch(1);
        private boolean hasBegun;

        StuckDisk(OutputStream out) {
            this.out = out;
        }

        @Override
        public void write(byte[] bytes, int from, int length) throws IOException {
            try {
                if (hasBegun) {
                    freed.await();
                }
                hasBegun = true;
                out.write(bytes, from, length);
            } catch (InterruptedException e) {
                throw new IOException(e);
            }
        }

        @Override
        public void write(int b) throws IOException {
            write(new byte[] {(byte) b}, 0, 1);
        }

        @Override
        public void close() {
            freed.countDown();
        }
    }
}
