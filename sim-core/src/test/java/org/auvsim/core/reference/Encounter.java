package org.auvsim.core.reference;

/**
 * Two bodies on their free flights, and when they come near each other. Where the gap is wide the
 * search leaps ahead by what the speeds allow; where it is narrow it looks every {@value #FINEST} s
 * and between, so that no dip below a margin is passed over that is deeper than 1e-9 m.
 */
final class Encounter {
    private static final double FINEST = 1e-5;
    private static final int HALVINGS = 36;

    private final Flight flightA;
    private final Solid a;
    private final Flight flightB;
    private final Solid b;
    private final double spin;
    private double least;

    Encounter(Flight flightA, Solid a, Flight flightB, Solid b) {
        this.flightA = flightA;
        this.a = a;
        this.flightB = flightB;
        this.b = b;
        spin = flightA.spinBound() * a.swing() + flightB.spinBound() * b.swing();
    }

    /** Gap (m) at an instant; 0 or less if they share a point. */
    double gap(double t) {
        a.follow(flightA.at(t));
        b.follow(flightB.at(t));
        double gap = Double.POSITIVE_INFINITY;
        for (Part part : a.parts()) {
            gap = Math.min(gap, b.gapTo(part));
        }
        return gap;
    }

    /** The least gap (m) seen by the last search. */
    double least() {
        return least;
    }

    /** First instant from {@code from} to {@code to} with a gap of at most {@code margin} (m). */
    double firstWithin(double margin, double from, double to) {
        double[] t = {from, from, from};
        double[] g = new double[3];
        g[2] = gap(from);
        g[1] = g[2];
        g[0] = g[2];
        least = g[2];
        while (g[2] > margin && t[2] < to) {
            t[0] = t[1];
            g[0] = g[1];
            t[1] = t[2];
            g[1] = g[2];
            t[2] = Math.min(to, t[1] + Math.max(FINEST, leap(g[1] - margin, t[1], to)));
            g[2] = gap(t[2]);
            least = Math.min(least, g[2]);
            if (g[2] > margin && g[1] <= g[0] && g[1] <= g[2] && isNarrow(t)) {
                double bottom =
                        bottom(Math.max(t[0], t[1] - FINEST), Math.min(t[2], t[1] + FINEST));
                double lowest = gap(bottom);
                least = Math.min(least, lowest);
                if (lowest <= margin) {
                    return crossing(margin, t[0], bottom);
                }
            }
        }
        if (g[2] > margin) {
            return Double.POSITIVE_INFINITY;
        }
        return t[2] == from ? from : crossing(margin, t[1], t[2]);
    }

    /** Whether one of the last two leaps was longer than the speeds allow, but the finest. */
    private static boolean isNarrow(double[] t) {
        return Math.min(t[1] - t[0], t[2] - t[1]) <= 1.5 * FINEST;
    }

    /** How far ahead (s) a gap this wide (m) cannot close. */
    private double leap(double gap, double from, double to) {
        double end = Math.min(to, from + 4 * gap / closing(from, to));
        return Math.min(end - from, gap / closing(from, end));
    }

    private double closing(double from, double to) {
        return flightA.speedBound(from, to) + flightB.speedBound(from, to) + spin;
    }

    /** Golden-section search for the least gap. */
    private double bottom(double from, double to) {
        double share = (Math.sqrt(5) - 1) / 2;
        double low = from;
        double high = to;
        double one = high - share * (high - low);
        double two = low + share * (high - low);
        double gapOne = gap(one);
        double gapTwo = gap(two);
        for (int i = 0; i < 40; i++) {
            if (gapOne < gapTwo) {
                high = two;
                two = one;
                gapTwo = gapOne;
                one = high - share * (high - low);
                gapOne = gap(one);
            } else {
                low = one;
                one = two;
                gapOne = gapTwo;
                two = low + share * (high - low);
                gapTwo = gap(two);
            }
        }
        return (low + high) / 2;
    }

    private double crossing(double margin, double apart, double within) {
        double low = apart;
        double high = within;
        for (int i = 0; i < HALVINGS; i++) {
            double middle = (low + high) / 2;
            if (gap(middle) <= margin) {
                high = middle;
            } else {
                low = middle;
            }
        }
        return high;
    }
}
