package org.auvsim.viz.window;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import java.awt.Component;
import java.io.File;
import java.nio.file.Path;

import javax.swing.JFileChooser;
import javax.swing.JPanel;

/** Somebody chooses files; needs a display. */
@Tag("display")
class FolderTest {
    @TempDir private Path elsewhere;
    private final Folder folder = new Folder();
    private final Component over = new JPanel();

    @Test
    void beginsInTheWorkingDirectoryAndThenWhereTheLastFileWas() throws Exception {
        Clicks.inSwing(
                () -> {
                    assertThat(begin()).isEqualTo(new File(System.getProperty("user.dir")));
                    assertThat(folder.toOpen(answering(JFileChooser.CANCEL_OPTION), over))
                            .isEmpty();
                    assertThat(begin()).isEqualTo(new File(System.getProperty("user.dir")));
                    Path file = elsewhere.resolve("a.xml");
                    assertThat(folder.toOpen(answering(JFileChooser.APPROVE_OPTION), over))
                            .contains(file);
                    assertThat(begin()).isEqualTo(elsewhere.toFile());
                });
    }

    private File begin() {
        return folder.chooser("Scenarios", "xml").getCurrentDirectory();
    }

    /** Somebody goes elsewhere there, and ends so. */
    private JFileChooser answering(int answer) {
        JFileChooser chooser =
                new JFileChooser() {
                    private static final long serialVersionUID = 1L;

                    @Override
                    public int showOpenDialog(Component over) {
                        return answer;
                    }
                };
        chooser.setCurrentDirectory(elsewhere.toFile());
        chooser.setSelectedFile(elsewhere.resolve("a.xml").toFile());
        return chooser;
    }
}
