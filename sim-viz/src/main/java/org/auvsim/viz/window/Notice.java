package org.auvsim.viz.window;

import java.awt.Component;

import javax.swing.JOptionPane;
import javax.swing.JTextArea;
import javax.swing.UIManager;

/** Tells somebody who has just acted in a dialog why that did not work. */
final class Notice {
    private static final int COLUMNS = 48;

    private Notice() {}

    /** Shows a sentence as a whole, however long it is, until it is closed. */
    static void show(Component over, String title, String sentence) {
        JTextArea words = new JTextArea(sentence, 0, COLUMNS);
        words.setName("notice");
        words.setLineWrap(true);
        words.setWrapStyleWord(true);
        words.setEditable(false);
        words.setOpaque(false);
        words.setFont(UIManager.getFont("Label.font"));
        words.setSize(words.getPreferredSize().width, Short.MAX_VALUE); // so it knows its height
        JOptionPane.showMessageDialog(over, words, title, JOptionPane.ERROR_MESSAGE);
    }
}
