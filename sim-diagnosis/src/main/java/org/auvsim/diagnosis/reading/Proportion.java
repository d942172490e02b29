package org.auvsim.diagnosis.reading;

/**
 * Sums over pairs of numbers of which one should be so many times the other, but for a constant.
 */
final class Proportion {
    private int count;
    private double x;
    private double y;
    private double xx;
    private double xy;
    private double yy;

    void add(double one, double other) {
        count++;
        double dx = one - x;
        double dy = other - y;
        x += dx / count;
        y += dy / count;
        xx += dx * (one - x);
        yy += dy * (other - y);
        xy += dx * (other - y);
    }

    /** How many pairs. */
    int count() {
        return count;
    }

    /** How many times the one the other is. */
    double slope() {
        return xy / xx;
    }

    /** -1 to 1; NaN where one of them never changes. */
    double correlation() {
        return xy / Math.sqrt(xx * yy);
    }
}
