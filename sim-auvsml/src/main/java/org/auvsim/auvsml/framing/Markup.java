package org.auvsim.auvsml.framing;

import java.nio.charset.StandardCharsets;
import java.util.Arrays;

/**
 * XML's markup, a byte at a time: enough to see where tags, quotes, comments, CDATA sections and
 * processing instructions begin and end. All of markup is ASCII, so that UTF-8 needs no decoding.
 */
final class Markup {
    /** What a byte meant. */
    enum Event {
        /** Nothing of interest. */
        NONE,
        /** A '<' that may begin a tag. */
        TAG_BEGINS,
        /** A '<' where none may stand; taken as the beginning of a tag. */
        MISPLACED_TAG_BEGINS,
        /** The name of a start tag is complete. */
        START_TAG_NAMED,
        /** An attribute's value begins. */
        ATTRIBUTE_BEGINS,
        /** A tag without content ends. */
        EMPTY_TAG_ENDS,
        /** An end tag ends. */
        END_TAG_ENDS,
        /** A processing instruction or XML declaration ends. */
        INSTRUCTION_ENDS,
        /** A DOCTYPE or another declaration begins. */
        FORBIDDEN,
        /** Text that is not white space. */
        TEXT
    }

    private enum State {
        TEXT,
        OPENED,
        START_NAME,
        IN_TAG,
        QUOTED,
        END_NAME,
        BANG,
        COMMENT,
        CDATA,
        INSTRUCTION
    }

    private static final byte[] ROOT = "auvsml".getBytes(StandardCharsets.US_ASCII);
    private static final byte[] OTHER_ROOT = "auvxml".getBytes(StandardCharsets.US_ASCII);

    /** By byte: whether it can end no tag, value or line, and is one column wide. */
    private static final boolean[] PLAIN = new boolean[256];

    static {
        Arrays.fill(PLAIN, ' ', 0x7F, true);
        for (char c : "<>\"'".toCharArray()) {
            PLAIN[c] = false;
        }
    }

    private final byte[] name = new byte[64];
    private State state = State.TEXT;
    private boolean searching;
    private int nameLength;
    private int attributes;
    private byte quote;
    private byte last;
    private int run;

    Event accept(byte b) {
        Event event =
                switch (state) {
                    case TEXT -> text(b);
                    case OPENED -> opened(b);
                    case START_NAME -> startName(b);
                    case IN_TAG -> inTag(b);
                    case QUOTED -> quoted(b);
                    case END_NAME -> endName(b);
                    case BANG -> bang(b);
                    case COMMENT -> until(b, '-', 2);
                    case CDATA -> until(b, ']', 2);
                    case INSTRUCTION -> instruction(b);
                };
        last = b;
        return event;
    }

    /**
     * Takes bytes at once that mean nothing, for speed: plain ones inside a tag or value.
     *
     * @return how many, from {@code from} on
     */
    int plainRun(byte[] bytes, int from, int end) {
        if (state != State.QUOTED && state != State.IN_TAG) {
            return 0;
        }
        int i = from;
        while (i < end && PLAIN[bytes[i] & 0xFF]) {
            i++;
        }
        if (i > from) {
            last = bytes[i - 1];
        }
        return i - from;
    }

    /** Looks for nothing but the start tag of a root from now on, whatever surrounds it. */
    void search() {
        searching = true;
        if (state != State.OPENED) {
            state = State.TEXT;
        }
    }

    /** Whether a tag, comment or other markup has begun and not ended. */
    boolean isOpen() {
        return state != State.TEXT;
    }

    /** Whether the name read last is a root's. */
    boolean isRootName() {
        return nameLength == ROOT.length
                && (Arrays.equals(name, 0, nameLength, ROOT, 0, ROOT.length)
                        || Arrays.equals(name, 0, nameLength, OTHER_ROOT, 0, OTHER_ROOT.length));
    }

    /** The name, or the instruction's text, read last; cut off where it is long. */
    String name() {
        return new String(name, 0, Math.min(nameLength, name.length), StandardCharsets.UTF_8);
    }

    /** How many attributes the tag has so far. */
    int attributes() {
        return attributes;
    }

    private Event text(byte b) {
        if (b == '<') {
            state = State.OPENED;
            return Event.TAG_BEGINS;
        }
        return isIgnorable(b) ? Event.NONE : Event.TEXT;
    }

    private Event opened(byte b) {
        nameLength = 0;
        attributes = 0;
        run = 0;
        if (isNameByte(b)) {
            addToName(b);
            state = State.START_NAME;
            return Event.NONE;
        }
        if (b == '<') {
            return misplaced();
        }
        state =
                switch (b) {
                    case '/' -> State.END_NAME;
                    case '!' -> State.BANG;
                    case '?' -> State.INSTRUCTION;
                    default -> State.TEXT;
                };
        if (searching) {
            state = State.TEXT;
        }
        return state == State.TEXT ? Event.TEXT : Event.NONE;
    }

    private Event startName(byte b) {
        if (isNameByte(b)) {
            addToName(b);
            return Event.NONE;
        }
        if (b == '<') {
            return misplaced();
        }
        if (searching && !isRootName()) {
            state = State.TEXT;
            return Event.NONE;
        }
        searching = false;
        state = b == '>' ? State.TEXT : State.IN_TAG;
        return Event.START_TAG_NAMED;
    }

    private Event inTag(byte b) {
        return switch (b) {
            case '"', '\'' -> {
                quote = b;
                attributes++;
                state = State.QUOTED;
                yield Event.ATTRIBUTE_BEGINS;
            }
            case '<' -> misplaced();
            case '>' -> {
                state = State.TEXT;
                yield last == '/' ? Event.EMPTY_TAG_ENDS : Event.NONE;
            }
            default -> Event.NONE;
        };
    }

    private Event quoted(byte b) {
        if (b == '<') {
            return misplaced();
        }
        if (b == quote) {
            state = State.IN_TAG;
        }
        return Event.NONE;
    }

    private Event endName(byte b) {
        if (b == '<') {
            return misplaced();
        }
        if (b == '>') {
            state = State.TEXT;
            return Event.END_TAG_ENDS;
        }
        if (!isWhite(b)) {
            addToName(b);
        }
        return Event.NONE;
    }

    private Event bang(byte b) {
        if (b == '-' && last == '!') {
            return Event.NONE;
        }
        if (b == '-') {
            state = State.COMMENT;
            return Event.NONE;
        }
        if (b == '[') {
            state = State.CDATA;
            return Event.TEXT;
        }
        state = State.TEXT;
        return Event.FORBIDDEN;
    }

    private Event instruction(byte b) {
        if (b == '>' && last == '?') {
            state = State.TEXT;
            return Event.INSTRUCTION_ENDS;
        }
        addToName(b);
        return Event.NONE;
    }

    /** Ends a comment or section at '>' after at least {@code count} of a byte in a row. */
    private Event until(byte b, char repeated, int count) {
        if (b == '>' && run >= count) {
            state = State.TEXT;
        }
        run = b == repeated ? run + 1 : 0;
        return Event.NONE;
    }

    private Event misplaced() {
        state = State.OPENED;
        return Event.MISPLACED_TAG_BEGINS;
    }

    private void addToName(byte b) {
        if (nameLength < name.length) {
            name[nameLength] = b;
        }
        nameLength = Math.min(nameLength + 1, name.length + 1);
    }

    private static boolean isNameByte(byte b) {
        return (b >= 'a' && b <= 'z')
                || (b >= 'A' && b <= 'Z')
                || (b >= '0' && b <= '9')
                || b == '-'
                || b == '_'
                || b == ':'
                || b == '.'
                || b < 0;
    }

    private static boolean isWhite(byte b) {
        return b == ' ' || b == '\n' || b == '\r' || b == '\t';
    }

    /** White space, and the bytes of a byte order mark (EF BB BF). */
    private static boolean isIgnorable(byte b) {
        return isWhite(b) || b == (byte) 0xEF || b == (byte) 0xBB || b == (byte) 0xBF;
    }
}
