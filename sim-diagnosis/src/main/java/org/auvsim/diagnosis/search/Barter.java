package org.auvsim.diagnosis.search;

/** What may be instead of each other, in words: two numbers, either of which explains the runs. */
final class Barter {
    /** Factors nearer to each other are one and the same. */
    private static final double ALIKE = 0.05;

    private Barter() {}

    /**
     * Either, and what they are together: {@code a sensor delay of 0.700 s, or a clock offset of
     * 0.700 s, or parts of both: only their sum is told}. Of each counts what it is beyond that
     * which changes nothing.
     */
    static String words(Amount a, Amount b) {
        return "%s, or %s, or %s".formatted(a.words(), b.words(), together(a, b));
    }

    private static String together(Amount a, Amount b) {
        double one = a.of().value();
        double other = b.of().value();
        if (a.isFactor() && b.isFactor()) {
            if (areAlike(one * other, 1)) {
                return "any two whose ratio is " + a.number();
            }
            if (areAlike(one, other)) {
                return "any two whose product is " + a.number();
            }
        }
        if (a.isAddedTo(b) && areAlike(one, other)) {
            return "parts of both: only their sum is told";
        }
        if (a.isAddedTo(b) && areAlike(one, -other)) {
            return "parts of both: only their difference is told";
        }
        return "a part of the one and the rest of the other";
    }

    private static boolean areAlike(double a, double b) {
        return Math.abs(a - b) < ALIKE * Math.abs(b);
    }
}
