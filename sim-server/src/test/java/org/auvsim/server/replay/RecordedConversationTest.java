package org.auvsim.server.replay;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.auvsml.document.Scenario;
import org.auvsim.auvsml.document.recording.Reach;
import org.auvsim.auvsml.message.lockstep.HelloCommand;
import org.auvsim.auvsml.message.lockstep.ReadyCommand;
import org.auvsim.auvsml.recording.ClientSentUnreadable;
import org.auvsim.auvsml.recording.ClientWent;
import org.auvsim.auvsml.recording.RecordedInput;
import org.auvsim.core.world.World;
import org.auvsim.server.RawClient;
import org.auvsim.server.net.TcpTransport;
import org.auvsim.server.simulator.Simulator;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import java.io.ByteArrayOutputStream;
import java.util.OptionalDouble;
import java.util.Random;

/** Real conversations are recorded, and replayed bit for bit. */
@Timeout(60)
class RecordedConversationTest {
    private static final int STEPS = 60;

    @ParameterizedTest(name = "seed {0}, {2} by {1}")
    @CsvSource({
        "1, DirectPositionChangeFeedbackHandler, no-feedback-timestepper",
        "2, DirectPositionChangeFeedbackHandler, asynchronous-feedback-timestepper",
        "3, DirectPositionChangeFeedbackHandler, simple-fixed-time-feedback-timestepper",
        "4, VectorAdjustmentFeedbackHandler, simple-fixed-time-feedback-timestepper",
        "5, DirectPositionChangeFeedbackHandler, lockstep-timestepper",
        "6, VectorAdjustmentFeedbackHandler, lockstep-timestepper",
    })
    void aConversationIsReplayedBitForBit(long seed, String handler, String timestepper)
            throws Exception {
        boolean waits = timestepper.startsWith("simple") || timestepper.startsWith("lockstep");
        Scenario scenario =
                Recorded.scenario(
                        timestepper.startsWith("simple")
                                ? "<"
                                        + timestepper
                                        + " wait='60'><client name='client 1'/></"
                                        + timestepper
                                        + ">"
                                : "<" + timestepper + "/>");
        ByteArrayOutputStream file = new ByteArrayOutputStream();
        TcpTransport tcp = TcpTransport.onLoopback(0);
        long hash;
        int applied;
        try (Recorder recorder = Recorded.recorder(file, scenario);
                Simulator simulator =
                        Simulator.of(scenario)
                                .transport(tcp)
                                .rate(OptionalDouble.empty())
                                .paused()
                                .log(recorder)
                                .start();
                ScriptedRobot robot = new ScriptedRobot(tcp.port(), new Random(seed), handler)) {
            if (timestepper.startsWith("lockstep")) {
                robot.send(new HelloCommand("robot"), new ReadyCommand(0));
            }
            robot.steps(STEPS / 2, waits);
            try (RawClient other = RawClient.welcomed(tcp.port())) {
                other.send("<auvsml><step-command count='many'/></auvsml>");
                other.next("error-response");
                other.ask("1", "<get-world-object-list-command/>");
            }
            robot.steps(STEPS / 2, waits);
            applied = robot.applied();
            hash = simulator.ask(World::stateHash);
        }

        assertThat(applied > 0).isEqualTo(!timestepper.startsWith("no-"));
        assertThat(Recorded.entries(file.toByteArray()))
                .anyMatch(ClientSentUnreadable.class::isInstance)
                .anyMatch(ClientWent.class::isInstance)
                .anyMatch(e -> waits == (e instanceof RecordedInput in && in.duringStep()));
        for (int replays = 0; replays < 2; replays++) {
            try (Replayer replayer = Recorded.replayer(file.toByteArray())) {
                while (replayer.advanceTimestep()) {
                    assertThat(replayer.divergence()).isEmpty();
                }
                assertThat(replayer.divergence()).isEmpty();
                assertThat(replayer.steps()).isEqualTo(STEPS);
                assertThat(replayer.hashes()).isEqualTo(STEPS / 5 + 1);
                assertThat(replayer.world().stateHash()).isEqualTo(hash);
                assertThat(replayer.reach()).extracting(Reach::isWhole).isEqualTo(true);
            }
        }
    }
}
