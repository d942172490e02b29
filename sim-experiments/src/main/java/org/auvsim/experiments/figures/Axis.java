package org.auvsim.experiments.figures;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.stream.DoubleStream;

/**
 * An axis of a figure: what range it shows and where.
 *
 * @param label with the unit
 * @param begin coordinate of the low end (pixels)
 * @param end coordinate of the high end
 */
record Axis(String label, double low, double high, double begin, double end) {
    /** So many ticks are wanted. */
    private static final int TICKS = 6;

    /** An axis that shows all of these values and a little more. */
    static Axis of(String label, DoubleStream values, double begin, double end) {
        double[] sorted = values.sorted().toArray();
        double low = sorted[0];
        double high = sorted[sorted.length - 1];
        double room = high > low ? 0.04 * (high - low) : Math.max(0.5, Math.abs(high) / 10);
        return new Axis(label, low - room, high + room, begin, end);
    }

    /** Where a value is (pixels). */
    double place(double value) {
        return begin + (end - begin) * (value - low) / (high - low);
    }

    /** Round values within the range, 1, 2 or 5 times a power of ten apart. */
    List<Double> ticks() {
        List<Double> ticks = new ArrayList<>();
        double step = step();
        for (long k = (long) Math.ceil(low / step); k * step <= high; k++) {
            ticks.add(k * step);
        }
        return ticks;
    }

    private double step() {
        double rough = (high - low) / TICKS;
        double power = 1;
        while (power > rough) {
            power /= 10;
        }
        while (10 * power <= rough) {
            power *= 10;
        }
        double share = rough / power;
        return power * (share < 1.5 ? 1 : share < 3.5 ? 2 : share < 7.5 ? 5 : 10);
    }

    /** A tick's value with as many digits as the ticks need. */
    String text(double tick) {
        int digits = 0;
        for (double step = step(); step < 0.99 && digits < 9; step *= 10) {
            digits++;
        }
        return String.format(Locale.ROOT, "%." + digits + "f", tick + 0.0);
    }
}
