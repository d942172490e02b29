package org.auvsim.viz.window;

import java.awt.Component;

import javax.swing.JOptionPane;

/** Asks before something is done that cannot be undone. */
final class Question {
    private static final String CANCEL = "Cancel";

    private Question() {}

    /** Whether somebody chose the deed, in a word for its button; Enter and Escape cancel. */
    static boolean confirms(Component over, String question, String deed) {
        Object[] answers = {deed, CANCEL};
        int answer =
                JOptionPane.showOptionDialog(
                        over,
                        question,
                        deed,
                        JOptionPane.DEFAULT_OPTION,
                        JOptionPane.QUESTION_MESSAGE,
                        null,
                        answers,
                        CANCEL);
        return answer == 0;
    }
}
