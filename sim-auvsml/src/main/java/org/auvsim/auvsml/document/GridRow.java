package org.auvsim.auvsml.document;

/** A row of a grid's file: its line, and x, y, z (m), u, v, w (m/s). */
final class GridRow {
    private final long line;
    private final double[] numbers;

    GridRow(long line, double[] numbers) {
        this.line = line;
        this.numbers = numbers;
    }

    long line() {
        return line;
    }

    /** Number {@code column}: 0 to 2 are the place, 3 to 5 the velocity. */
    double get(int column) {
        return numbers[column];
    }

    /** Where it is, for people. */
    String place() {
        return "(%s, %s, %s)".formatted(numbers[0], numbers[1], numbers[2]);
    }
}
