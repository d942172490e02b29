package org.auvsim.viz.window;

import org.auvsim.viz.scene.Counted;
import org.jspecify.annotations.Nullable;

import java.awt.BorderLayout;
import java.awt.FlowLayout;
import java.awt.GridLayout;
import java.awt.Window;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.Optional;

import javax.swing.BorderFactory;
import javax.swing.JButton;
import javax.swing.JDialog;
import javax.swing.JFileChooser;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JSpinner;
import javax.swing.JTextField;
import javax.swing.SpinnerNumberModel;
import javax.swing.SwingUtilities;
import javax.swing.Timer;

/** Records frames into a folder until it is stopped; the window stays free meanwhile. */
final class FrameDialog {
    private final Desk desk;
    private final Window window;
    private final Recorder recorder;
    private final JTextField folder =
            new JTextField(System.getProperty("user.dir") + "/frames", 34);
    private final JSpinner rate = new JSpinner(new SpinnerNumberModel(25, 1, 60, 1));
    private final JTextField film = new JTextField();
    private final JLabel words = new JLabel(" ");
    private final JButton start = new JButton("Start");
    private final Timer timer = new Timer(40, e -> frame());
    private Optional<JDialog> opened = Optional.empty();
    private Path into = Path.of("");

    FrameDialog(Desk desk, Window window, Recorder recorder) {
        this.desk = desk;
        this.window = window;
        this.recorder = recorder;
        folder.setName("frames-folder");
        rate.setName("frames-rate");
        start.setName("frames-start");
        film.setName("frames-film");
        film.setEditable(false);
        words.setName("frames-words");
        folder.getDocument().addDocumentListener(Typing.calls(this::tell));
        rate.addChangeListener(e -> tell());
        start.addActionListener(e -> toggle());
        tell();
    }

    /** Shows it, or brings it to the front. */
    void open() {
        if (opened.isEmpty()) {
            opened = Optional.of(build());
        }
        opened.get().setVisible(true);
        opened.get().toFront();
    }

    private JDialog build() {
        JDialog dialog = new JDialog(window, "Record frames");
        dialog.setName("frames-dialog");
        JButton choose = new JButton("Choose...");
        choose.addActionListener(e -> choose(dialog));
        JPanel where = new JPanel(new BorderLayout(4, 0));
        where.add(folder);
        where.add(choose, BorderLayout.EAST);
        JPanel fast = new JPanel(new FlowLayout(FlowLayout.LEFT, 4, 0));
        fast.add(new JLabel("Frames a second"));
        fast.add(rate);
        fast.add(start);
        JPanel all = new JPanel(new GridLayout(0, 1, 4, 6));
        all.setBorder(BorderFactory.createEmptyBorder(12, 12, 12, 12));
        all.add(new JLabel("Folder for the numbered PNG files"));
        all.add(where);
        all.add(fast);
        all.add(new JLabel("A film of them makes:"));
        all.add(film);
        JPanel below = new JPanel(new BorderLayout(8, 0));
        below.add(words);
        below.add(Closing.of(dialog), BorderLayout.EAST);
        all.add(below);
        dialog.add(all);
        dialog.pack();
        dialog.setLocationRelativeTo(window);
        return dialog;
    }

    private void choose(JDialog dialog) {
        JFileChooser chooser = new JFileChooser(folder.getText());
        chooser.setFileSelectionMode(JFileChooser.DIRECTORIES_ONLY);
        if (chooser.showOpenDialog(dialog) == JFileChooser.APPROVE_OPTION) {
            folder.setText(chooser.getSelectedFile().getPath());
        }
    }

    private void tell() {
        film.setText(Recorder.film(folder.getText(), (Integer) rate.getValue()));
        film.setCaretPosition(0);
    }

    /** Starts, or stops. */
    void toggle() {
        if (timer.isRunning()) {
            stop();
            return;
        }
        try {
            into = Path.of(folder.getText());
        } catch (InvalidPathException e) {
            words.setText("No folder can have this name: %s.".formatted(e.getReason()));
            return;
        }
        if (Files.exists(Recorder.frame(into, 1))) {
            words.setText("There are frames in this folder: choose another.");
            return;
        }
        int framesASecond = (Integer) rate.getValue();
        recorder.begin(framesASecond);
        timer.setDelay(1000 / (2 * framesASecond)); // often enough that a late call misses none
        timer.start();
        start.setText("Stop");
        folder.setEditable(false);
        rate.setEnabled(false);
    }

    private void stop() {
        timer.stop();
        start.setText("Start");
        folder.setEditable(true);
        rate.setEnabled(true);
        var _ = recorder.end(into).whenComplete((done, failure) -> tell(failure));
        desk.say("Wrote %s into %s.".formatted(Counted.of(recorder.frames(), "frame"), into));
    }

    private void frame() {
        recorder.record(into, this::tell);
        words.setText(Counted.of(recorder.frames(), "frame"));
    }

    /** Tells of a failure, if it is one. */
    private void tell(@Nullable Throwable failure) {
        if (failure != null) {
            SwingUtilities.invokeLater(() -> fail(failure));
        }
    }

    private void fail(Throwable failure) {
        if (timer.isRunning()) {
            stop();
        }
        String sentence = Desk.sentence(failure);
        if (!sentence.equals(words.getText())) {
            words.setText(sentence);
            desk.say(sentence);
        }
    }
}
