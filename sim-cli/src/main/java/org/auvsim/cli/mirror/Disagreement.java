package org.auvsim.cli.mirror;

/** How far apart (m) two simulators have an object, over a run. */
final class Disagreement {
    private final String name;
    private int compared;
    private double sumOfSquares;
    private double largest;
    private double last;

    Disagreement(String name) {
        this.name = name;
    }

    void add(double distance) {
        compared++;
        sumOfSquares += distance * distance;
        largest = Math.max(largest, distance);
        last = distance;
    }

    /** What there is to tell of it. */
    MirrorTally.Row row() {
        return new MirrorTally.Row(
                name, compared, Math.sqrt(sumOfSquares / Math.max(1, compared)), largest, last);
    }
}
