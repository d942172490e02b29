package org.auvsim.server.replay;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.core.world.World;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;

/**
 * A recording that was made once is replayed to the states that it tells, bit for bit. Where
 * physics or format were changed on purpose, it is made anew with {@code -Dauvsml.generate}.
 */
@Timeout(60)
class GoldenRecordingTest {
    /** Tests run in the module's folder. */
    private static final Path GOLDEN =
            Path.of("src/test/resources/org/auvsim/server/replay/golden.auvsml");

    @Test
    void itIsReplayedBitForBit() throws Exception {
        if (System.getProperty("auvsml.generate") != null) {
            Files.writeString(GOLDEN, ReplayerTest.unpacked(record()));
        }
        ReplayerTest.equalHash(Files.readAllBytes(GOLDEN));
    }

    /** A push, a collision, feedback in time and late, and something that cannot be read. */
    private static byte[] record() throws IOException {
        try (RecordedSession session =
                new RecordedSession(
                        Recorded.scenario(
                                "<asynchronous-feedback-timestepper/>",
                                "feedback-horizon=\"0.5\""))) {
            session.steps(3);
            session.push(4);
            session.steps(4);
            double now = session.simulator().ask(World::time);
            assertThat(session.correct(now, 0.3)).contains("command-done");
            session.steps(3);
            assertThat(session.correct(1.6, 0.15)).contains("command-done");
            session.client().send("<auvsml><step-command count='two'/></auvsml>");
            session.client().next("error-response");
            session.steps(5);
            return session.recording();
        }
    }
}
