package org.auvsim.viz.window;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.viz.camera.OrbitCamera;
import org.auvsim.viz.drawing.ViewOptions;
import org.auvsim.viz.scene.Counted;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

import java.awt.Window;
import java.awt.event.ActionEvent;
import java.awt.event.KeyEvent;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;

import javax.swing.AbstractButton;
import javax.swing.JDialog;
import javax.swing.JFrame;
import javax.swing.JLabel;
import javax.swing.JTextField;
import javax.swing.KeyStroke;

/** Somebody records frames; needs a display. */
@Tag("display")
@Timeout(60)
class FrameDialogTest {
    @TempDir private Path folder;
    private final FakeScreen screen = new FakeScreen();
    private final Recorder recorder = new Recorder(screen);
    private final JFrame frame = new JFrame();
    private final Desk desk =
            new Desk(
                    new FakeRecording(Scenes.withBuoy()),
                    new OrbitCamera(),
                    screen,
                    new ViewOptions());
    private final FrameDialog frames = new FrameDialog(desk, frame, recorder);

    @AfterEach
    void close() throws Exception {
        Clicks.inSwing(frame::dispose);
        recorder.close();
    }

    private JDialog dialog() {
        return Stream.of(frame.getOwnedWindows())
                .filter(JDialog.class::isInstance)
                .map(JDialog.class::cast)
                .findFirst()
                .orElseThrow();
    }

    @Test
    void recordsFramesUntilItIsStopped() throws Exception {
        Clicks.inSwing(
                () -> {
                    frames.open();
                    Clicks.find(dialog(), "frames-folder", JTextField.class)
                            .setText(folder.toString());
                    Clicks.find(dialog(), "frames-start", AbstractButton.class).doClick(0);
                });
        while (!Files.exists(Recorder.frame(folder, 2))) {
            Thread.onSpinWait();
        }
        List<String> told = new ArrayList<>();
        desk.onWords(words -> told.add(words.text()));
        Clicks.inSwing(
                () -> {
                    AbstractButton start =
                            Clicks.find(dialog(), "frames-start", AbstractButton.class);
                    assertThat(start.getText()).isEqualTo("Stop");
                    start.doClick(0);
                    assertThat(start.getText()).isEqualTo("Start");
                    String count = Counted.of(recorder.frames(), "frame");
                    assertThat(told).containsExactly("Wrote " + count + " into " + folder + ".");
                    // What is there is not written over.
                    start.doClick(0);
                    assertThat(start.getText()).isEqualTo("Start");
                });
    }

    @Test
    void aNameThatNoFolderCanHaveIsToldInWords() throws Exception {
        Clicks.inSwing(
                () -> {
                    frames.open();
                    Clicks.find(dialog(), "frames-folder", JTextField.class).setText("a\0b");
                    AbstractButton start =
                            Clicks.find(dialog(), "frames-start", AbstractButton.class);
                    start.doClick(0);
                    assertThat(start.getText()).isEqualTo("Start");
                    assertThat(Clicks.find(dialog(), "frames-words", JLabel.class).getText())
                            .startsWith("No folder can have this name: ");
                });
    }

    @Test
    void escapeClosesItAndItComesBackAsItWas() throws Exception {
        Clicks.inSwing(
                () -> {
                    frames.open();
                    JDialog dialog = dialog();
                    Clicks.find(dialog, "frames-folder", JTextField.class).setText("elsewhere");
                    dialog.getRootPane()
                            .getActionForKeyStroke(KeyStroke.getKeyStroke(KeyEvent.VK_ESCAPE, 0))
                            .actionPerformed(new ActionEvent(dialog, 0, ""));
                    assertThat(dialog.isShowing()).isFalse();
                    frames.open();
                    assertThat(Stream.of(frame.getOwnedWindows()).filter(Window::isShowing))
                            .containsExactly(dialog);
                    assertThat(Clicks.find(dialog, "frames-folder", JTextField.class).getText())
                            .isEqualTo("elsewhere");
                });
    }
}
