package org.auvsim.viz.window;

import java.awt.Component;
import java.io.File;
import java.nio.file.Path;
import java.util.Optional;

import javax.swing.JFileChooser;
import javax.swing.filechooser.FileNameExtensionFilter;

/** Where files are chosen: first in the working directory, then where the last one was. */
final class Folder {
    private File current = new File(System.getProperty("user.dir"));

    /** A chooser that begins here. */
    JFileChooser chooser(String kind, String suffix) {
        JFileChooser chooser = new JFileChooser(current);
        chooser.setFileFilter(new FileNameExtensionFilter(kind, suffix));
        return chooser;
    }

    /** The file that somebody opens by a chooser; empty if none. */
    Optional<Path> toOpen(JFileChooser chooser, Component over) {
        return chosen(chooser, chooser.showOpenDialog(over));
    }

    /** The file that somebody saves as by a chooser; empty if none. */
    Optional<Path> toSave(JFileChooser chooser, Component over) {
        return chosen(chooser, chooser.showSaveDialog(over));
    }

    private Optional<Path> chosen(JFileChooser chooser, int answer) {
        if (answer != JFileChooser.APPROVE_OPTION) {
            return Optional.empty();
        }
        current = chooser.getCurrentDirectory();
        return Optional.of(chooser.getSelectedFile().toPath());
    }
}
