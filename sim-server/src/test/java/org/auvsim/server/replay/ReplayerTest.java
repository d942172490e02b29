package org.auvsim.server.replay;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import static java.nio.charset.StandardCharsets.UTF_8;

import org.auvsim.auvsml.document.DocumentException;
import org.auvsim.auvsml.document.recording.RecordingReader;
import org.auvsim.auvsml.message.command.EventType;
import org.auvsim.auvsml.message.control.ApplyDirectForceCommand;
import org.auvsim.auvsml.message.entity.DescribeWorldObjectRequest;
import org.auvsim.auvsml.message.listening.ListenerRegistrationRequestCommand;
import org.auvsim.auvsml.recording.Entry;
import org.auvsim.auvsml.recording.StepFailed;
import org.auvsim.auvsml.recording.WaitTimedOut;
import org.auvsim.core.entity.Frame;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.world.World;
import org.auvsim.server.RawClient;
import org.auvsim.server.simulator.Simulator;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.util.Arrays;
import java.util.List;
import java.util.OptionalDouble;
import java.util.zip.GZIPInputStream;

@Timeout(60)
class ReplayerTest {
    private static final String ASYNCHRONOUS = "<asynchronous-feedback-timestepper/>";

    /** Twenty steps with a push after each fifth. */
    private static byte[] pushed() throws IOException {
        try (RecordedSession session = new RecordedSession(Recorded.scenario(ASYNCHRONOUS))) {
            for (int i = 0; i < 4; i++) {
                session.push(i - 1.5);
                session.steps(5);
            }
            return session.recording();
        }
    }

    /** The end of a replay that must find no difference. */
    static long equalHash(byte[] recording) throws Exception {
        try (Replayer replayer = Recorded.replayer(recording)) {
            while (replayer.advanceTimestep()) {
                assertThat(replayer.divergence()).isEmpty();
            }
            assertThat(replayer.divergence()).isEmpty();
            assertThat(replayer.hashes()).isPositive();
            assertThat(replayer.reach().isWhole()).isTrue();
            return replayer.world().stateHash();
        }
    }

    @Test
    void lateFeedbackCorrectsThePastOfTheReplayToo() throws Exception {
        try (RecordedSession session =
                new RecordedSession(Recorded.scenario(ASYNCHRONOUS, "feedback-horizon=\"0.5\""))) {
            for (int i = 1; i < 6; i++) {
                session.steps(6);
                session.push(i);
                double now = session.simulator().ask(World::time);
                assertThat(session.correct(now - 0.15, 0.3 * i)).contains("command-done");
                assertThat(session.correct(now - 0.8, 0.3)).contains("error-response");
            }
            session.steps(1);
            long hash = session.simulator().ask(World::stateHash);
            byte[] recording = session.recording();

            assertThat(Recorded.entries(recording)).last().returns(5, Entry::revision);
            assertThat(equalHash(recording)).isEqualTo(hash);
        }
    }

    @Test
    void whatTheWorldWasReplacedByReplacesItInTheReplayToo() throws Exception {
        try (RecordedSession session = new RecordedSession(Recorded.scenario(ASYNCHRONOUS))) {
            RawClient client = session.client();
            session.steps(4);
            client.ask("1", "<take-snapshot-command name='then'/>");
            session.push(3);
            session.steps(7);
            client.ask("2", "<restore-snapshot-command name='then'/>");
            session.steps(3);
            client.ask(
                    "3",
                    "<load-scenario-command><scenario><no-feedback-timestepper/>"
                            + "<world-object id='1' name='Other' mass='1'><sphere radius='1'/>"
                            + "<velocity x='1' y='0' z='0'/></world-object>"
                            + "</scenario></load-scenario-command>");
            session.push(2);
            session.steps(6);
            client.ask("4", "<reset-command/>");
            session.steps(5);
            long hash = session.simulator().ask(World::stateHash);
            byte[] recording = session.recording();

            assertThat(Recorded.entries(recording)).last().returns(3, Entry::revision);
            assertThat(equalHash(recording)).isEqualTo(hash);
        }
    }

    @Test
    void waitsThatTimedOutDoSoInTheReplay() throws Exception {
        try (RecordedSession session =
                new RecordedSession(
                        Recorded.scenario("<lockstep-timestepper timeout='0.02' then='go-on'/>"))) {
            session.client().ask("h", "<hello-command name='robot'/>");
            for (int i = 0; i < 5; i++) {
                session.client().send("<auvsml>" + RecordedSession.pushing(i) + "</auvsml>");
                session.steps(2);
            }
            long hash = session.simulator().ask(World::stateHash);
            byte[] recording = session.recording();

            assertThat(Recorded.entries(recording)).anyMatch(WaitTimedOut.class::isInstance);
            assertThat(equalHash(recording)).isEqualTo(hash);
        }
    }

    @Test
    void aStepThatWasGivenUpInItsWaitIsGivenUpInTheReplay() throws Exception {
        try (RecordedSession session =
                new RecordedSession(Recorded.scenario("<lockstep-timestepper/>"))) {
            session.steps(3);
            session.client()
                    .ask(
                            "l",
                            "<listener-registration-request-command register='1'><world-object"
                                    + " id='*'><listener type='TimestepAdvanced'/></world-object>"
                                    + "</listener-registration-request-command>");
            session.client().ask("h", "<hello-command name='robot'/>");
            session.client().send("<auvsml><step-command/></auvsml>");
            assertThat(session.client().next("timestep-advanced")).contains("PROJECTED");
            byte[] recording = session.recording();

            assertThat(Recorded.entries(recording)).anyMatch(StepFailed.class::isInstance);
            try (Replayer replayer = Recorded.replayer(recording)) {
                while (replayer.advanceTimestep()) {
                    assertThat(replayer.steps()).isLessThanOrEqualTo(3);
                }
                assertThat(replayer.divergence()).isEmpty();
            }
        }
    }

    @Test
    void aStepThatFailedFailsInTheReplay() throws Exception {
        String stepper =
                "<snapshot-stepper><maximum-speed-restricter speed='3'/></snapshot-stepper>";
        try (RecordedSession session = new RecordedSession(Recorded.scenario(stepper))) {
            session.steps(2);
            session.push(4000);
            session.steps(2);
            session.push(-1);
            byte[] recording = session.recording();

            assertThat(Recorded.entries(recording)).anyMatch(StepFailed.class::isInstance);
            equalHash(recording);
        }
    }

    @Test
    void whatDiffersFirstIsToldWithStepTimeObjectAndValue() throws Exception {
        String text = unpacked(pushed());
        byte[] edited = text.replaceFirst("x=\"0\\.5\"", "x=\"0.6\"").getBytes(UTF_8);

        try (Replayer replayer = Recorded.replayer(edited)) {
            while (replayer.advanceTimestep()) {
                assertThat(replayer.steps()).isLessThanOrEqualTo(20);
            }
            assertThat(replayer.steps()).isEqualTo(20);
            Divergence first = replayer.divergence().orElseThrow();
            assertThat(first.step()).isEqualTo(11);
            assertThat(first.time()).isCloseTo(2.05, within(1e-9));
            assertThat(first.sentence())
                    .startsWith("the replay differs from the recording at step 11 (2.0")
                    .contains("'Robot' (id 1): position.x was ")
                    .matches(".* was -?[0-9.]+, but is -?[0-9.]+ now");
        }
    }

    @Test
    void aHashAloneThatDiffersIsToldToo() throws Exception {
        String text =
                unpacked(pushed())
                        .replaceFirst("(step=\"10\" timestamp=\"[^\"]*\" hash=\")....", "$10000");

        assertThat(difference(text)).startsWith("the replay differs from the recording at step 10");
        assertThat(difference(text)).contains("the state's hash was 0000");
    }

    @Test
    void aMovementThatWasNotRecordedIsToldToo() throws Exception {
        String text =
                unpacked(pushed())
                        .replaceFirst(
                                "<movement-state-change-message timestamp=\"[^\"]*\""
                                    + " world-object-id=\"3\".*?</movement-state-change-message>",
                                "");

        assertThat(difference(text))
                .contains(
                        "'Float' (id 3): what happened was nothing, but is"
                                + " movement-state-change-message of 'Float' (id 3) now");
    }

    private static String difference(String recording) throws Exception {
        try (Replayer replayer = Recorded.replayer(recording.getBytes(UTF_8))) {
            while (replayer.advanceTimestep()) {
                assertThat(replayer.steps()).isLessThanOrEqualTo(20);
            }
            return replayer.divergence().orElseThrow().sentence();
        }
    }

    @Test
    void aRecordingThatWasCutOffIsReplayedAsFarAsItGoes() throws Exception {
        byte[] text = unpacked(pushed()).getBytes(UTF_8);
        for (int length = text.length / 2; length < text.length - 1; length += 1000) {
            try (Replayer replayer = Recorded.replayer(Arrays.copyOf(text, length))) {
                while (replayer.advanceTimestep()) {
                    assertThat(replayer.divergence()).isEmpty();
                }
                assertThat(replayer.divergence()).isEmpty();
                assertThat(replayer.reach().isWhole()).isFalse();
                assertThat(replayer.steps()).isEqualTo(replayer.reach().step());
            }
        }
    }

    @Test
    void aRecordingThatCannotBeReadAnyFurtherIsRefusedThere() throws Exception {
        String text =
                unpacked(pushed()).replaceFirst("<state-hash revision=\"0\" step=\"15\"", "<x");

        try (Replayer replayer = Recorded.replayer(text.getBytes(UTF_8))) {
            assertThatThrownBy(
                            () -> {
                                while (replayer.advanceTimestep()) {
                                    assertThat(replayer.steps()).isLessThan(20);
                                }
                            })
                    .isInstanceOf(DocumentException.class)
                    .hasMessageContaining("no entry of a recording has the name 'x'");
            assertThat(replayer.steps()).isEqualTo(15);
        }
    }

    @Test
    void viewersSeeTheReplayAndChangeNothing() throws Exception {
        RecordingReader reader = Recorded.reader(pushed());
        Viewer viewer =
                new Viewer(
                        ListenerRegistrationRequestCommand.of(
                                "1", List.of(EventType.MOVEMENT_STATE_CHANGE)),
                        new DescribeWorldObjectRequest(1),
                        new ApplyDirectForceCommand(1, "p", Frame.WORLD, new Vec3(9, 0, 0)));
        try (Replayer replayer =
                new Replayer(
                        reader,
                        Simulator.of(reader.scenario())
                                .rate(OptionalDouble.empty())
                                .transport(viewer))) {
            while (replayer.advanceTimestep()) {
                assertThat(replayer.divergence()).isEmpty();
            }
            assertThat(replayer.divergence()).isEmpty();
            assertThat(replayer.steps()).isEqualTo(20);
        }
        assertThat(viewer.heard())
                .contains("role=\"viewer\"")
                .contains("<world-object-description-response><world-object id=\"1\"")
                .contains("needs the role controller, but client 1000000001 is a viewer")
                .contains("<movement-state-change-message timestamp=\"1.55\"")
                .contains("<movement-state-change-message timestamp=\"2.5")
                .contains("<disconnected-notification reason=\"the replay has ended\"/>");
    }

    static String unpacked(byte[] recording) throws IOException {
        ByteArrayOutputStream text = new ByteArrayOutputStream();
        try (GZIPInputStream in = new GZIPInputStream(new ByteArrayInputStream(recording))) {
            in.transferTo(text);
        }
        return text.toString(UTF_8);
    }
}
