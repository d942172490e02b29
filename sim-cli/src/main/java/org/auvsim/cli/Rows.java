package org.auvsim.cli;

import java.nio.file.Path;

/** How commands tell what they have written. */
final class Rows {
    private Rows() {}

    /** So many rows of a table, in a file. */
    static String written(long count, Path file) {
        return "%d %s written to %s".formatted(count, count == 1 ? "row" : "rows", place(file));
    }

    /** A file's name, or what "-" stands for. */
    static String place(Path file) {
        return file.equals(Path.of("-")) ? "the standard output" : file.toString();
    }
}
