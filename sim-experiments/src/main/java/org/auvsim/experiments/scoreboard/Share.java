package org.auvsim.experiments.scoreboard;

import java.util.Locale;

/** So many of so many, as a share with the 95 % interval of Wilson (JASA 22, 1927). */
public record Share(int hits, int of) {
    /** Of a normal distribution: 95 % are within so many deviations. */
    private static final double Z = 1.959964;

    /** Between 0 and 1; NaN of nothing. */
    public double value() {
        return (double) hits / of;
    }

    /** The lower end of the interval. */
    public double low() {
        return Math.max(0, middle() - half());
    }

    /** The upper end of the interval. */
    public double high() {
        return Math.min(1, middle() + half());
    }

    private double middle() {
        return (value() + Z * Z / (2 * of)) / (1 + Z * Z / of);
    }

    private double half() {
        double p = value();
        return Z * Math.sqrt(p * (1 - p) / of + Z * Z / (4.0 * of * of)) / (1 + Z * Z / of);
    }

    @Override
    public String toString() {
        return of == 0
                ? "-"
                : String.format(
                        Locale.ROOT,
                        "%.1f %% (%d of %d, %.0f-%.0f)",
                        100 * value(),
                        hits,
                        of,
                        100 * low(),
                        100 * high());
    }
}
