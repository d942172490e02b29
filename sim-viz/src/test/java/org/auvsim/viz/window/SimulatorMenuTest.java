package org.auvsim.viz.window;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.auvsml.message.control.LoadScenarioCommand;
import org.auvsim.viz.camera.OrbitCamera;
import org.auvsim.viz.drawing.ViewOptions;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

import java.awt.Window;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicReference;
import java.util.stream.Stream;

import javax.swing.JDialog;
import javax.swing.JFrame;
import javax.swing.JTextArea;

/** An administrator loads scenarios; needs a display for the window. */
@Tag("display")
@Timeout(60)
class SimulatorMenuTest {
    @TempDir private Path folder;
    private final FakeSimulator simulator = new FakeSimulator(Scenes.withBuoy());
    private final Desk desk =
            new Desk(simulator, new OrbitCamera(), new FakeScreen(), new ViewOptions());
    private final JFrame frame = new JFrame();
    private final SimulatorMenu menu = new SimulatorMenu(desk, frame);

    @AfterEach
    void close() throws Exception {
        Clicks.inSwing(frame::dispose);
    }

    @Test
    void aScenarioIsReadAndSentOnlyIfThatIsMeant() throws Exception {
        Path file = Path.of("..", "examples", "scenarios", "tank.xml");
        Clicks.inSwing(() -> menu.load(file));
        Clicks.answer("Cancel");
        Clicks.inSwing(() -> {});
        assertThat(simulator.asked).isEmpty();
        Clicks.inSwing(() -> menu.load(file));
        Clicks.answer("Load");
        Clicks.inSwing(() -> {});
        assertThat(simulator.asked)
                .singleElement()
                .isInstanceOfSatisfying(
                        LoadScenarioCommand.class,
                        command -> assertThat(command.scenario().worldObject()).isNotEmpty());
    }

    @Test
    void aFileThatIsNoScenarioIsASentence() throws Exception {
        BlockingQueue<String> words = new LinkedBlockingQueue<>();
        desk.onWords(occurrence -> words.add(occurrence.text()));
        Path file = Files.writeString(folder.resolve("no.xml"), "<scenario><tank/></scenario>");
        Clicks.inSwing(() -> menu.load(file));
        String sentence = words.poll(30, TimeUnit.SECONDS);
        assertThat(sentence).contains("no.xml").contains("tank");
        assertThat(simulator.asked).isEmpty();
        assertThat(notice()).isEqualTo(sentence);
        Clicks.answer("OK");
    }

    @Test
    void whyASimulatorDoesNotTakeAScenarioIsShownAsAWhole() throws Exception {
        simulator.refusal = Optional.of("The scenario is not for me.");
        Path file = Path.of("..", "examples", "scenarios", "tank.xml");
        Clicks.inSwing(() -> menu.load(file));
        Clicks.answer("Load");
        assertThat(notice()).isEqualTo("The scenario is not for me.");
        Clicks.answer("OK");
    }

    /** The words of the notice that comes. */
    private static String notice() throws Exception {
        AtomicReference<String> words = new AtomicReference<>("");
        while (words.get().isEmpty()) {
            Clicks.inSwing(
                    () ->
                            Stream.of(Window.getWindows())
                                    .filter(Window::isShowing)
                                    .filter(JDialog.class::isInstance)
                                    .map(JDialog.class::cast)
                                    .forEach(
                                            dialog ->
                                                    words.set(
                                                            Clicks.find(
                                                                            dialog,
                                                                            "notice",
                                                                            JTextArea.class)
                                                                    .getText())));
        }
        return words.get();
    }
}
