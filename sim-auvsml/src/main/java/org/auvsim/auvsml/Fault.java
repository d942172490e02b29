package org.auvsim.auvsml;

/**
 * One thing that is wrong with a text, and where.
 *
 * @param code its kind
 * @param problem what was expected and what was found, in a sentence without the place
 * @param path the way to the place from the root, as {@code auvsml/position@z}; may be empty
 * @param line the place's line, from 1
 * @param column the place's column, from 1, in UTF-16 units
 */
public record Fault(ErrorCode code, String problem, String path, int line, int column) {
    /** The problem with its path, for people. */
    public String sentence() {
        return path.isEmpty() ? problem : problem + " at " + path;
    }

    /** The place in a file of this name, as compilers tell it, and the sentence. */
    public String in(Object file) {
        return "%s:%d:%d: %s".formatted(file, line, column, sentence());
    }

    /** The same fault in a text that begins at this line and column of a longer one. */
    public Fault shiftedTo(int startLine, int startColumn) {
        return new Fault(
                code,
                problem,
                path,
                line + startLine - 1,
                line == 1 ? column + startColumn - 1 : column);
    }

    @Override
    public String toString() {
        return "line " + line + ", column " + column + ": " + sentence();
    }
}
