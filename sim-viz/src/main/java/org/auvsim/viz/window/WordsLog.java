package org.auvsim.viz.window;

import org.auvsim.viz.scene.Occurrence;

import java.util.Locale;

import javax.swing.DefaultListModel;
import javax.swing.JList;
import javax.swing.JScrollPane;

/** The list of what happened, the newest at the end. */
final class WordsLog {
    /** So many lines are kept. */
    private static final int MOST = 500;

    private final DefaultListModel<String> lines = new DefaultListModel<>();
    private final JList<String> list = new JList<>(lines);
    private final JScrollPane pane = new JScrollPane(list);

    WordsLog(Desk desk) {
        list.setName("log");
        desk.onWords(this::add);
        desk.onRefresh(() -> desk.scene().drainOccurrences().forEach(desk::tell));
    }

    JScrollPane component() {
        return pane;
    }

    private void add(Occurrence occurrence) {
        boolean isAtEnd = list.getLastVisibleIndex() >= lines.size() - 2;
        lines.addElement(
                String.format(Locale.ROOT, "%10.2f s   %s", occurrence.time(), occurrence.text()));
        if (lines.size() > MOST) {
            lines.remove(0);
        }
        if (isAtEnd) {
            list.ensureIndexIsVisible(lines.size() - 1);
        }
    }
}
