package org.auvsim.cli;

import static org.assertj.core.api.Assertions.assertThat;

import static java.nio.charset.StandardCharsets.UTF_8;

import org.auvsim.auvsml.client.AuvsmlClient;
import org.auvsim.auvsml.client.Received;
import org.auvsim.auvsml.document.recording.SmallDisk;
import org.auvsim.auvsml.message.command.ListenedObject;
import org.auvsim.auvsml.message.entity.DescribeWorldObjectRequest;
import org.auvsim.auvsml.message.entity.WorldObjectDescriptionResponse;
import org.auvsim.auvsml.message.listening.ListenerRegistrationRequestCommand;
import org.auvsim.auvsml.message.movement.TimestepAdvancedNotification;
import org.auvsim.core.entity.WorldObjectDefinition;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import picocli.CommandLine;

import java.io.BufferedReader;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.zip.GZIPInputStream;

/** {@code auvsim serve --record} and {@code auvsim replay}. */
@Timeout(120)
class ReplayTest {
    private static final String SCENARIO =
            """
            <scenario>
              <no-feedback-timestepper/>
              <world-object name="Boat" mass="2"><sphere radius="0.5"/><velocity x="1" y="0" z="0"/>
                <damping><linear x="1" y="1" z="1"/></damping></world-object>
              <world-object name="Buoy" mass="1"><sphere radius="0.5"/><position x="1.3" y="0.1" z="0"/>
              </world-object>
            </scenario>
            """;

    @TempDir private Path folder;
    private CommandLineHarness auvsim;
    private Path scenario;
    private Path recording;

    @BeforeEach
    void begin() throws IOException {
        auvsim = new CommandLineHarness(folder);
        scenario = auvsim.file("boat.xml", SCENARIO);
        recording = folder.resolve("run.auvsml.gz");
    }

    /** Records so many seconds as fast as it can. */
    private int record(double seconds, Object... options) {
        List<Object> arguments = new ArrayList<>(List.of("serve"));
        arguments.addAll(recording(seconds));
        arguments.addAll(List.of(options));
        return auvsim.run(arguments.toArray());
    }

    private List<Object> recording(double seconds) {
        return List.of(
                scenario, "--port", 0, "--rate", "max", "--until", seconds, "--record", recording);
    }

    private int replay(Object... options) {
        List<Object> arguments = new ArrayList<>(List.of("replay", recording));
        arguments.addAll(List.of(options));
        auvsim = new CommandLineHarness(folder);
        return auvsim.run(arguments.toArray());
    }

    private void unpackAndEdit(String is, String becomes) throws IOException {
        try (GZIPInputStream in = new GZIPInputStream(Files.newInputStream(recording))) {
            String text = new String(in.readAllBytes(), UTF_8);
            assertThat(text).containsPattern(is);
            Files.writeString(recording, text.replaceFirst(is, becomes));
        }
    }

    @Test
    void whatWasRecordedIsReplayed() {
        assertThat(record(5, "--hash-every", 10)).isZero();

        assertThat(replay()).isZero();
        assertThat(auvsim.out()).isEqualTo("100 steps replayed, 11 hashes equal\n");
        assertThat(replay("--until", 2)).isZero();
        assertThat(auvsim.out()).isEqualTo("40 steps replayed, 5 hashes equal\n");
    }

    @Test
    void oneStepAndOneHashAreToldAsSuch() {
        assertThat(record(0.05)).isZero();

        assertThat(replay()).isZero();
        assertThat(auvsim.out()).isEqualTo("1 step replayed, 1 hash equal\n");
    }

    @Test
    void anEndBeforeTheStartIsRefused() {
        record(1);

        assertThat(replay("--until", -1)).isEqualTo(2);
        assertThat(auvsim.err())
                .isEqualTo(
                        "--until must be after the recording's start at 0.0 s, but is -1.0 s.\n");
    }

    @ParameterizedTest
    @CsvSource({
        "--force, --force is for a recording; name its file by --record.",
        "--hash-every=3, --hash-every is for a recording; name its file by --record."
    })
    void whatIsForARecordingNeedsOne(String option, String sentence) {
        assertThat(auvsim.run("serve", scenario, "--port", 0, "--until", 1, option)).isEqualTo(2);
        assertThat(auvsim.err()).isEqualTo(sentence + "\n");
    }

    @Test
    void aRecordingIsNoFolder() {
        recording = folder;

        assertThat(record(1, "--force")).isEqualTo(2);
        assertThat(auvsim.err())
                .isEqualTo("--record needs a file, but %s is a folder.\n".formatted(folder));
    }

    @Test
    void aScenarioAndARecordingGivenForEachOtherAreToldApart() {
        record(1);
        assertThat(auvsim.run("serve", recording, "--port", 0)).isEqualTo(2);
        assertThat(auvsim.err())
                .isEqualTo(recording + " is a recording; replay it with 'auvsim replay'\n");

        recording = scenario;
        assertThat(replay()).isEqualTo(2);
        assertThat(auvsim.err()).isEqualTo(scenario + " is a scenario, no recording\n");
    }

    @Test
    void aDifferenceIsToldWithStepTimeObjectAndValue() throws IOException {
        record(5);
        unpackAndEdit("<velocity x=\"1.0\"", "<velocity x=\"1.1\"");

        assertThat(replay()).isEqualTo(1);
        assertThat(auvsim.out())
                .startsWith(
                        recording
                                + ": the replay differs from the recording at step 0 (0.0 s):"
                                + " 'Boat' (id 1): linearMomentum.x was 2.0, but is 2.2 now")
                .hasLineCount(1);
    }

    @Test
    void oneThatWasCutOffIsReplayedAsFarAsItGoes() throws IOException {
        record(30);
        byte[] whole = Files.readAllBytes(recording);
        assertThat(whole.length).isGreaterThan(5_000);
        for (int length = 1_000; length < whole.length; length += 1_000) {
            Files.write(recording, Arrays.copyOf(whole, length));

            assertThat(replay()).isZero();
            assertThat(auvsim.out())
                    .containsPattern("steps replayed, |nothing was checked")
                    .contains(recording + ": it reaches step ")
                    .contains("the recording was cut off there");
        }
    }

    @Test
    void oneWithoutAStepIsSaidToCheckNothing() throws IOException {
        record(5);
        try (GZIPInputStream in = new GZIPInputStream(Files.newInputStream(recording))) {
            String text = new String(in.readAllBytes(), UTF_8);
            String begun = text.substring(0, text.indexOf("\n<happened"));
            int firstHash = text.indexOf("\n<state-hash");
            String compared = text.substring(0, text.indexOf('\n', firstHash + 1));

            assertThat(replayed(begun + "\n"))
                    .startsWith("no step is recorded: nothing was checked\n");
            assertThat(replayed(compared + "\n"))
                    .startsWith("no step is recorded: nothing but the beginning was checked\n");
        }
    }

    private String replayed(String text) throws IOException {
        Files.writeString(recording, text);
        assertThat(replay()).isZero();
        return auvsim.out();
    }

    @Test
    void aRecordingThatBreaksOffIsToldAtTheEnd() {
        ByteArrayOutputStream file = new ByteArrayOutputStream();
        Serve serve = new Serve(new RecordingOptions((_, _) -> new SmallDisk(file, 4_000)));
        StringWriter err = new StringWriter();
        String[] arguments = recording(30).stream().map(Object::toString).toArray(String[]::new);
        int exit =
                new CommandLine(serve)
                        .setOut(new PrintWriter(new StringWriter()))
                        .setErr(new PrintWriter(err))
                        .execute(arguments);

        assertThat(exit).isEqualTo(1);
        assertThat(err.toString())
                .isEqualToNormalizingNewlines(
                        "The recording ends before the simulation did: it cannot be written: No"
                                + " space left on device.\n");
        assertThat(file.size()).isEqualTo(4_000);
    }

    @Test
    void aChangedByteIsRefused() throws IOException {
        record(5);
        byte[] bytes = Files.readAllBytes(recording);
        bytes[bytes.length / 2] ^= 4;
        Files.write(recording, bytes);

        assertThat(replay()).isEqualTo(2);
        assertThat(auvsim.err())
                .startsWith(
                        recording + ": the recording is damaged or was changed: its gzip member")
                .hasLineCount(1);
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            textBlock =
                    """
                    version="1" | version="2" | :1:1: root element 1: the recording has the format's version 2, but this auvsim reads version 1
                    <state-hash | <state-sum  | no entry of a recording has the name 'state-sum'
                    step="20"   | step="2"    | its step must be
                    """)
    void whatCannotBeUsedIsToldInASentence(String is, String becomes, String sentence)
            throws IOException {
        record(5);
        unpackAndEdit(is, becomes);

        assertThat(replay()).isEqualTo(2);
        assertThat(auvsim.err()).startsWith(recording + ":").contains(sentence).hasLineCount(1);
    }

    @Test
    void aFileThatIsNotThereOrNoRecordingIsToldSo() throws IOException {
        assertThat(replay()).isEqualTo(2);
        assertThat(auvsim.err()).isEqualTo(recording + ": there is no such file\n");
        recording = scenario;
        assertThat(replay()).isEqualTo(2);
        assertThat(auvsim.err()).contains("is a scenario, no recording").hasLineCount(1);
    }

    @Test
    void aRecordingIsOverwrittenByForceAlone() {
        assertThat(record(1)).isZero();
        assertThat(record(2)).isEqualTo(2);
        assertThat(auvsim.err())
                .isEqualTo(
                        recording
                                + " is there already; name another file, or overwrite it with"
                                + " --force.\n");
        assertThat(replay()).isZero();
        assertThat(auvsim.out()).startsWith("20 steps replayed");
        assertThat(record(2, "--force")).isZero();
        assertThat(replay()).isZero();
        assertThat(auvsim.out()).startsWith("40 steps replayed");
    }

    @Test
    void wrongOptionsOfRecordingAreExplained() {
        assertThat(record(1, "--force", "--hash-every", 0)).isEqualTo(2);
        recording = folder.resolve("no").resolve("run.auvsml.gz");
        assertThat(record(1)).isEqualTo(2);
        assertThat(auvsim.err())
                .isEqualTo(
                        "--hash-every must be 1 or more, but is 0.\nCannot write "
                                + recording
                                + ": its folder does not exist.\n");
    }

    @Test
    void viewersAreServed() throws Exception {
        record(60);
        List<String> arguments = List.of(recording.toString(), "--port", "0", "--rate", "realtime");
        try (OtherProcess replaying = new OtherProcess("replay", arguments);
                AuvsmlClient viewer = AuvsmlClient.connect("127.0.0.1", replaying.port())) {
            assertThat(viewer.welcome().role()).isEqualTo("viewer");
            assertThat(timeHeard(viewer, 0)).isPositive();
            WorldObjectDefinition boat = described(viewer, 1);
            assertThat(boat.name()).isEqualTo("Boat");
            assertThat(boat.position().x()).isPositive();
        }
    }

    private static WorldObjectDefinition described(AuvsmlClient client, long id) throws Exception {
        client.send(new DescribeWorldObjectRequest(id));
        for (Optional<Received> next = client.next(); next.isPresent(); next = client.next()) {
            for (var message : next.get().messages()) {
                if (message instanceof WorldObjectDescriptionResponse answer) {
                    return answer.worldObject();
                }
            }
        }
        throw new AssertionError("the server has ended");
    }

    @Test
    void aServerThatIsKilledLeavesWhatCanBeReplayed() throws Exception {
        List<String> arguments =
                List.of(
                        scenario.toString(),
                        "--port",
                        "0",
                        "--rate",
                        "10",
                        "--record",
                        recording.toString());
        try (OtherProcess server = new OtherProcess("serve", arguments);
                AuvsmlClient client = AuvsmlClient.connect("127.0.0.1", server.port())) {
            long beginning = Files.size(recording);
            double time = 0;
            while (Files.size(recording) == beginning) {
                time = timeHeard(client, time);
            }
            server.kill();
        }

        assertThat(replay()).isZero();
        assertThat(auvsim.out())
                .containsPattern("^[1-9][0-9,]* steps replayed, [1-9][0-9,]* hash(es)? equal\n")
                .contains("the recording was cut off there");
        assertThat(logOfReplay()).doesNotContain("has come");
    }

    /** What a replay writes to the standard error of a process of its own. */
    private String logOfReplay() throws IOException {
        Process replay =
                OtherProcess.builder("replay", List.of(recording.toString()))
                        .redirectOutput(ProcessBuilder.Redirect.DISCARD)
                        .start();
        return new String(replay.getErrorStream().readAllBytes(), UTF_8);
    }

    /** Listens until the world's time is beyond this one (s), and returns it. */
    private static double timeHeard(AuvsmlClient client, double after) throws Exception {
        client.send(ListenerRegistrationRequestCommand.ofAll(ListenedObject.EVERY));
        for (Optional<Received> next = client.next(); next.isPresent(); next = client.next()) {
            for (var message : next.get().messages()) {
                if (message instanceof TimestepAdvancedNotification step
                        && step.timestamp() > after) {
                    return step.timestamp();
                }
            }
        }
        throw new AssertionError("the server has ended");
    }

    /** A command that serves, in a process of its own. */
    private static final class OtherProcess implements AutoCloseable {
        private final Process process;
        private final int port;

        OtherProcess(String command, List<String> arguments) throws IOException {
            process =
                    builder(command, arguments)
                            .redirectError(ProcessBuilder.Redirect.DISCARD)
                            .start();
            BufferedReader out = process.inputReader(UTF_8);
            String first = out.readLine();
            port = Integer.parseInt(first.substring(first.lastIndexOf(':') + 1));
        }

        /** How its process is started. */
        static ProcessBuilder builder(String command, List<String> arguments) {
            List<String> words = OwnProcess.java();
            words.addAll(List.of(Auvsim.class.getName(), command));
            words.addAll(arguments);
            return new ProcessBuilder(words);
        }

        int port() {
            return port;
        }

        /** Ends it as {@code kill -9} does. */
        void kill() {
            process.destroyForcibly().onExit().join();
        }

        @Override
        public void close() {
            kill();
        }
    }
}
