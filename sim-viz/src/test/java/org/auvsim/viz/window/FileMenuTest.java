package org.auvsim.viz.window;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.viz.camera.OrbitCamera;
import org.auvsim.viz.drawing.ViewOptions;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;

import javax.imageio.ImageIO;
import javax.swing.JFrame;
import javax.swing.SwingUtilities;

/** Somebody saves pictures; needs a display for the question. */
@Tag("display")
@Timeout(60)
class FileMenuTest {
    @TempDir private Path folder;
    private final BlockingQueue<String> words = new LinkedBlockingQueue<>();
    private final FakeScreen screen = new FakeScreen();
    private final Recorder recorder = new Recorder(screen);
    private final JFrame frame = new JFrame();
    private final Desk desk =
            new Desk(
                    new FakeRecording(Scenes.withBuoy()),
                    new OrbitCamera(),
                    screen,
                    new ViewOptions());
    private final FileMenu menu = new FileMenu(desk, frame, recorder, () -> {});

    @BeforeEach
    void listen() {
        desk.onWords(occurrence -> words.add(occurrence.text()));
    }

    @AfterEach
    void close() throws Exception {
        recorder.close();
        Clicks.inSwing(frame::dispose);
    }

    private String told() throws InterruptedException {
        return String.valueOf(words.poll(30, TimeUnit.SECONDS));
    }

    @Test
    void aNameWithoutASuffixBecomesAPngFile() throws Exception {
        Clicks.inSwing(() -> menu.saveAs(folder.resolve("sea")));
        Path file = folder.resolve("sea.png");
        assertThat(told()).isEqualTo("The picture is in " + file + ".");
        assertThat(ImageIO.read(file.toFile()).getWidth()).isEqualTo(32);
    }

    @Test
    void aPictureThatIsThereIsWrittenOverOnlyIfThatIsMeant() throws Exception {
        Path file = Files.writeString(folder.resolve("old.png"), "old");
        SwingUtilities.invokeLater(() -> menu.saveAs(file));
        Clicks.answer("Cancel");
        Clicks.inSwing(() -> {});
        assertThat(words).isEmpty();
        assertThat(file).hasContent("old");
        SwingUtilities.invokeLater(() -> menu.saveAs(file));
        Clicks.answer("Write over");
        assertThat(told()).startsWith("The picture is in ");
        assertThat(ImageIO.read(file.toFile()).getWidth()).isEqualTo(32);
    }

    @Test
    void aPictureThatCannotBeWrittenIsASentence() throws Exception {
        Path file = Files.createFile(folder.resolve("file")).resolve("a.png");
        Clicks.inSwing(() -> menu.saveAs(file));
        assertThat(told()).startsWith("Cannot write the picture " + file);
    }
}
