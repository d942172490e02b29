package org.auvsim.auvsml.message;

/**
 * Text of clients that stands in lines of logs and of shells: it cannot begin a line of its own.
 */
public final class OneLine {
    private OneLine() {}

    /**
     * The text, if it is one line.
     *
     * @param what sentences call it
     * @throws IllegalArgumentException if there are control characters or line separators in it
     */
    public static String of(String what, String text) {
        int bad = text.chars().filter(OneLine::isBreaking).findFirst().orElse(-1);
        if (bad >= 0) {
            throw new IllegalArgumentException(
                    "%s must be one line without control characters, but has U+%04X in it; leave it out"
                            .formatted(what, bad));
        }
        return text;
    }

    private static boolean isBreaking(int character) {
        int type = Character.getType(character);
        return Character.isISOControl(character)
                || type == Character.LINE_SEPARATOR
                || type == Character.PARAGRAPH_SEPARATOR;
    }
}
