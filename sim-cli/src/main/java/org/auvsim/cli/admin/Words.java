package org.auvsim.cli.admin;

import org.auvsim.cli.report.UserError;

import java.util.ArrayList;
import java.util.List;

/**
 * A line taken apart.
 *
 * @param words what blanks separate; what stands in double quotes belongs together
 * @param xml what begins with {@code <}, to the end of the line
 */
record Words(List<String> words, String xml) {
    /**
     * The parts of a line.
     *
     * @throws UserError if a quotation does not end
     */
    static Words of(String line) {
        List<String> words = new ArrayList<>();
        StringBuilder word = new StringBuilder();
        boolean inWord = false;
        boolean quoted = false;
        for (int i = 0; i < line.length(); i++) {
            char c = line.charAt(i);
            if (c == '<' && !quoted && !inWord) {
                return new Words(words, line.substring(i).strip());
            }
            if (c == '"') {
                quoted = !quoted;
                inWord = true;
            } else if (Character.isWhitespace(c) && !quoted) {
                if (inWord) {
                    words.add(word.toString());
                    word.setLength(0);
                }
                inWord = false;
            } else {
                word.append(c);
                inWord = true;
            }
        }
        if (quoted) {
            throw new UserError("A quotation does not end: close it with \".");
        }
        if (inWord) {
            words.add(word.toString());
        }
        return new Words(words, "");
    }
}
