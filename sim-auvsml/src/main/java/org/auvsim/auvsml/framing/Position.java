package org.auvsim.auvsml.framing;

/** Line and column of a stream's next byte, from 1; columns in UTF-16 units, as the parser's. */
final class Position {
    private int line = 1;
    private int column = 1;
    private long offset;
    private boolean afterReturn;

    int line() {
        return line;
    }

    int column() {
        return column;
    }

    /** How many bytes have passed. */
    long offset() {
        return offset;
    }

    void pass(byte b) {
        offset++;
        if (b == '\r' || (b == '\n' && !afterReturn)) {
            line++;
            column = 1;
        } else if (b != '\n') {
            column += units(b);
        }
        afterReturn = b == '\r';
    }

    /** Passes so many bytes of ASCII without line breaks. */
    void passPlain(int length) {
        offset += length;
        column += length;
        afterReturn = false;
    }

    /** A character is counted at its first byte; one of four bytes is two UTF-16 units. */
    private static int units(byte b) {
        if ((b & 0xC0) == 0x80) {
            return 0;
        }
        return (b & 0xF8) == 0xF0 ? 2 : 1;
    }
}
