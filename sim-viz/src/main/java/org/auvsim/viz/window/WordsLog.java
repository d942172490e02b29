package org.auvsim.viz.window;

import org.auvsim.viz.scene.Occurrence;

import java.util.Locale;

import javax.swing.BoundedRangeModel;
import javax.swing.JScrollPane;
import javax.swing.JTextArea;
import javax.swing.SwingUtilities;
import javax.swing.text.DefaultCaret;

/** The list of what happened, the newest at the end; long lines are wrapped. */
final class WordsLog {
    /** So many lines are kept. */
    private static final int MOST = 500;

    private final JTextArea lines = new JTextArea();
    private final JScrollPane pane = new JScrollPane(lines);

    WordsLog(Desk desk) {
        lines.setName("log");
        lines.setEditable(false);
        lines.setLineWrap(true);
        lines.setWrapStyleWord(true);
        ((DefaultCaret) lines.getCaret()).setUpdatePolicy(DefaultCaret.NEVER_UPDATE);
        desk.onWords(this::add);
        desk.onRefresh(() -> desk.scene().drainOccurrences().forEach(desk::tell));
    }

    JScrollPane component() {
        return pane;
    }

    private void add(Occurrence occurrence) {
        BoundedRangeModel scrolled = pane.getVerticalScrollBar().getModel();
        boolean isAtEnd = scrolled.getValue() + scrolled.getExtent() >= scrolled.getMaximum();
        lines.append(
                String.format(
                        Locale.ROOT, "%10.2f s   %s\n", occurrence.time(), occurrence.text()));
        if (lines.getLineCount() > MOST + 1) {
            lines.replaceRange("", 0, lines.getText().indexOf('\n') + 1);
        }
        if (isAtEnd) {
            SwingUtilities.invokeLater(() -> scrolled.setValue(scrolled.getMaximum()));
        }
    }
}
