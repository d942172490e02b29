package org.auvsim.cli;

import static org.assertj.core.api.Assertions.assertThat;

import static java.nio.charset.StandardCharsets.UTF_8;

import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;

import javax.imageio.ImageIO;

/** What is wrong is one sentence each, and exit code 2. */
@Timeout(60)
class ViewTest {
    private static final Path TANK =
            CommandLineHarness.EXAMPLES.resolve("scenarios").resolve("tank.xml");

    /** Whether there is a display Java finds out by itself. */
    private static final String UNASKED = "-Dfile.encoding=UTF-8";

    @TempDir private Path folder;
    private CommandLineHarness auvsim;

    @BeforeEach
    void begin() {
        auvsim = new CommandLineHarness(folder);
    }

    private void refuses(String sentence, Object... arguments) {
        assertThat(auvsim.run(arguments)).isEqualTo(2);
        assertThat(auvsim.err()).contains(sentence);
        assertThat(auvsim.err().lines().filter(line -> line.contains("\tat "))).isEmpty();
    }

    /** Without a window, which would need a display. */
    private void refusesToPaint(String sentence, Object... arguments) {
        List<Object> all = new ArrayList<>(List.of("view"));
        all.addAll(List.of(arguments));
        all.addAll(List.of("--picture", folder.resolve("x.png")));
        refuses(sentence, all.toArray());
    }

    private Path recording() {
        Path file = folder.resolve("run.auvsml.gz");
        CommandLineHarness server = new CommandLineHarness(folder);
        int code =
                server.run(
                        "serve",
                        TANK,
                        "--port",
                        0,
                        "--until",
                        2,
                        "--rate",
                        "max",
                        "--record",
                        file);
        assertThat(code).as(server.err()).isZero();
        return file;
    }

    @Test
    void nobodyListens() throws IOException {
        int free;
        try (ServerSocket socket = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
            free = socket.getLocalPort();
        }
        refuses("Nobody listens at 127.0.0.1:" + free, "view", "127.0.0.1:" + free);
    }

    /** Says something to whoever comes, and ends the connection. */
    private void refusesAServerThatSays(String greeting, String sentence) throws Exception {
        try (ServerSocket socket = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
            Thread server =
                    Thread.startVirtualThread(
                            () -> {
                                try (Socket client = socket.accept()) {
                                    client.getOutputStream().write(greeting.getBytes(UTF_8));
                                    client.shutdownOutput();
                                    client.getInputStream().readAllBytes();
                                } catch (IOException e) {
                                    throw new AssertionError(e);
                                }
                            });
            refuses(sentence, "view", "127.0.0.1:" + socket.getLocalPort());
            server.join();
        }
    }

    @Test
    void whatAnswersIsNoServerOfAuvsml() throws Exception {
        refusesAServerThatSays("HTTP/1.1 400 Bad Request\r\n\r\n", "is not an AUVSML server");
    }

    @Test
    void whatAnswersSpeaksAnotherVersion() throws Exception {
        refusesAServerThatSays(
                "<auvsml><welcome-message protocol-version=\"9\" server=\"auvsim 7\""
                        + " session-id=\"1\" role=\"viewer\"/></auvsml>",
                "speaks version 9 of AUVSML, this program version 1");
    }

    @Test
    void aFileThatIsMissingOrDamagedOrNoRecording() throws IOException {
        refusesToPaint("there is no such file", folder.resolve("gone.auvsml.gz"));
        refusesToPaint("is a scenario, no recording", TANK);
        Path notes = Files.writeString(folder.resolve("notes.txt"), "# To do");
        refusesToPaint("notes.txt:1:1: this is no recording: ", notes);
        Path damaged = recording();
        byte[] bytes = Files.readAllBytes(damaged);
        int changed = bytes.length / 2;
        bytes[changed] ^= 0x55;
        Files.write(damaged, bytes);
        refusesToPaint("run.auvsml.gz: the recording is damaged", damaged);
        Matcher told = Pattern.compile("from byte (\\d+) on").matcher(auvsim.err());
        assertThat(told.find()).as(auvsim.err()).isTrue();
        assertThat(Integer.parseInt(told.group(1))).isBetween(1, changed);
    }

    /** The recording is no recording, which would be found next. */
    @Test
    void whatIsWrongWithTheOptionsIsFoundBeforeTheRecordingIsRead() throws IOException {
        Path notes = Files.writeString(folder.resolve("notes.txt"), "# To do");
        refuses("There is no renderer 'crayon'", "view", notes, "--renderer", "crayon");
        refuses(
                "sea.v2.jpg has another name: name it sea.v2.png.",
                "view",
                notes,
                "--picture",
                folder.resolve("sea.v2.jpg"));
        refuses(
                "x.png: its folder does not exist.",
                "view",
                notes,
                "--picture",
                folder.resolve("gone").resolve("x.png"));
    }

    @Test
    @Tag("display")
    void aRecordingThatIsCutOffIsShownAsFarAsItGoesAndThatIsTold() throws IOException {
        Path whole = recording();
        byte[] bytes = Files.readAllBytes(whole);
        Path cut = folder.resolve("cut.auvsml.gz");
        Files.write(cut, Arrays.copyOf(bytes, 2 * bytes.length / 3));
        Path picture = folder.resolve("cut.png");
        assertThat(auvsim.run("view", cut, "--picture", picture)).as(auvsim.err()).isZero();
        assertThat(auvsim.err())
                .containsPattern("cut.auvsml.gz: notice: it is shown up to [01]\\.[0-9]+ s: ");
        assertThat(picture).exists();
    }

    @Test
    void aRendererThatCannotPaintIsOneSentence() throws IOException {
        ExtensionFolder extensions =
                new ExtensionFolder(Files.createDirectories(folder.resolve("extensions")));
        extensions.add("chalk.jar", ExtensionFolder.RENDERER, "own.Chalk", ExtensionFolder.CHALK);
        refuses(
                "Chalk paints nothing.",
                "view",
                recording(),
                "--renderer",
                "chalk",
                "--extensions",
                extensions.path(),
                "--picture",
                folder.resolve("x.png"));
    }

    @Test
    void anOptionThatCannotBe() {
        Path recording = recording();
        refuses("There is no renderer 'gl'; there is jme", "view", recording, "--renderer", "gl");
        refusesToPaint("--at must be within the recording", recording, "--at", 99);
        refuses("a port is a number from 1 to 65535", "view", "127.0.0.1:99999");
        refusesToPaint("--at must be within the recording", recording, "--at", "NaN");
        refuses("as 1280x800, but found 'big'", "view", recording, "--size", "big");
        refuses(
                "There is no object 'Nemo' to follow; there are AUV-1701",
                "view",
                recording,
                "--follow",
                "Nemo",
                "--picture",
                folder.resolve("x.png"));
    }

    private static String[] aimOf(boolean picture, Path recording, Path file) {
        return picture
                ? new String[] {recording.toString(), "--picture", file.toString()}
                : new String[] {recording.toString()};
    }

    /** In a process of its own, as this one may have a display. */
    @Test
    void withoutADisplayThereIsNoWindow() throws Exception {
        assertThat(refused(Map.of(), "-Djava.awt.headless=true", recording().toString()))
                .startsWith("There is no display here")
                .satisfies(ViewTest::tellsWhatToDo);
    }

    @ParameterizedTest(name = "a picture: {0}")
    @ValueSource(booleans = {false, true})
    @EnabledOnOs(OS.LINUX)
    void withoutTheVariableDisplayNothingIsPainted(boolean picture) throws Exception {
        Path file = folder.resolve("x.png");
        String said = refused(Map.of(), UNASKED, aimOf(picture, recording(), file));
        assertThat(said)
                .containsIgnoringCase("no display")
                .contains("DISPLAY")
                .satisfies(ViewTest::tellsWhatToDo);
        assertThat(file).doesNotExist();
    }

    @ParameterizedTest(name = "a picture: {0}")
    @ValueSource(booleans = {false, true})
    @EnabledOnOs(OS.LINUX)
    void onADisplayThatIsNotThereNothingIsPainted(boolean picture) throws Exception {
        Path file = folder.resolve("x.png");
        Map<String, String> nowhere = Map.of("DISPLAY", ":9999");
        String said = refused(nowhere, UNASKED, aimOf(picture, recording(), file));
        assertThat(said)
                .containsIgnoringCase("no display")
                .contains(":9999")
                .satisfies(ViewTest::tellsWhatToDo);
        assertThat(file).doesNotExist();
    }

    /** Mesa takes the version from the environment. */
    @ParameterizedTest(name = "a picture: {0}")
    @ValueSource(booleans = {false, true})
    @Tag("display")
    void withoutOpenGlNothingIsPainted(boolean picture) throws Exception {
        Map<String, String> old =
                Map.of(
                        "DISPLAY",
                        System.getenv("DISPLAY"),
                        "LIBGL_ALWAYS_SOFTWARE",
                        "1",
                        "__GLX_VENDOR_LIBRARY_NAME",
                        "mesa",
                        "MESA_GL_VERSION_OVERRIDE",
                        "2.1");
        Path file = folder.resolve("x.png");
        String said = refused(old, "-Djava.awt.headless=false", aimOf(picture, recording(), file));
        assertThat(said).contains("no display with OpenGL 3.2").satisfies(ViewTest::tellsWhatToDo);
        assertThat(file).doesNotExist();
    }

    private static void tellsWhatToDo(String said) {
        assertThat(said).contains("'auvsim watch'").contains("--renderer osp").endsWith(".");
        assertThat(said.lines()).hasSize(1);
    }

    /** What a viewer says that cannot show anything, but for what the virtual machine says. */
    private static String refused(
            Map<String, String> environment, String property, String... arguments)
            throws Exception {
        List<String> command = OwnProcess.java(property, "--enable-native-access=ALL-UNNAMED");
        command.addAll(List.of(Auvsim.class.getName(), "view"));
        command.addAll(List.of(arguments));
        ProcessBuilder builder = new ProcessBuilder(command).redirectErrorStream(true);
        builder.environment().remove("DISPLAY");
        builder.environment().putAll(environment);
        Process view = builder.start();
        String said = new String(view.getInputStream().readAllBytes(), UTF_8);
        assertThat(view.waitFor()).as(said).isEqualTo(2);
        return said.lines()
                .filter(line -> !line.isBlank() && !line.startsWith("WARNING: "))
                .filter(line -> !line.endsWith(" read")) // told of what takes long to read
                .collect(Collectors.joining("\n"));
    }

    @Test
    @Tag("display")
    void aPictureOfARecordingIsWritten() throws IOException {
        Path picture = folder.resolve("tank.png");
        int code =
                auvsim.run(
                        "view",
                        recording(),
                        "--picture",
                        picture,
                        "--size",
                        "320x200",
                        "--look",
                        "top",
                        "--at",
                        1);
        assertThat(code).as(auvsim.err()).isZero();
        BufferedImage image = ImageIO.read(picture.toFile());
        assertThat(image.getWidth()).isEqualTo(320);
        assertThat(image.getHeight()).isEqualTo(200);
    }
}
