package org.auvsim.viz.window;

import java.awt.Window;
import java.io.File;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.LocalDateTime;
import java.time.ZoneId;
import java.time.format.DateTimeFormatter;
import java.util.Locale;

import javax.swing.Action;
import javax.swing.JFileChooser;
import javax.swing.JMenu;
import javax.swing.SwingUtilities;

/** Pictures, films and the end. */
final class FileMenu {
    private static final DateTimeFormatter TIME =
            DateTimeFormatter.ofPattern("yyyyMMdd-HHmmss", Locale.ROOT);

    private final Desk desk;
    private final Window window;
    private final Recorder recorder;
    private final Action save = new Act("Save picture...", this::choose).key("ctrl S");
    private final Action record;
    private final Action close;

    FileMenu(Desk desk, Window window, Recorder recorder, Runnable end) {
        this.desk = desk;
        this.window = window;
        this.recorder = recorder;
        FrameDialog dialog = new FrameDialog(desk, window, recorder);
        record = new Act("Record frames...", dialog::open).key("ctrl shift R");
        close = new Act("Close", end).key("ctrl Q");
    }

    JMenu menu() {
        JMenu menu = new JMenu("File");
        menu.setName("menu-file");
        menu.setMnemonic('F');
        menu.add(save).setName("save-picture");
        menu.add(record).setName("record-frames");
        menu.addSeparator();
        menu.add(close).setName("close");
        return menu;
    }

    Action save() {
        return save;
    }

    Action record() {
        return record;
    }

    static String pictureName() {
        return "auvsim-" + TIME.format(LocalDateTime.now(ZoneId.systemDefault())) + ".png";
    }

    private void choose() {
        JFileChooser chooser = desk.folder().chooser("PNG pictures", "png");
        chooser.setSelectedFile(new File(chooser.getCurrentDirectory(), pictureName()));
        desk.folder().toSave(chooser, window).ifPresent(this::saveAs);
    }

    /** Saves as a file that somebody has named; one that is there only if they say so. */
    void saveAs(Path named) {
        Path file = png(named);
        String question = "There is a file %s. Write over it?".formatted(file.getFileName());
        if (!Files.exists(file) || Question.confirms(window, question, "Write over")) {
            save(file);
        }
    }

    /** The same with .png at its end, if it has no suffix. */
    static Path png(Path named) {
        String name = String.valueOf(named.getFileName());
        return name.contains(".") ? named : named.resolveSibling(name + ".png");
    }

    /** Saves the next frame and tells how it went. */
    private void save(Path file) {
        var _ =
                recorder.save(file)
                        .whenComplete(
                                (done, failure) ->
                                        SwingUtilities.invokeLater(
                                                () ->
                                                        desk.say(
                                                                failure == null
                                                                        ? "The picture is in "
                                                                                + file
                                                                                + "."
                                                                        : Desk.sentence(failure))));
    }
}
