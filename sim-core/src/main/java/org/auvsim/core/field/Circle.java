package org.auvsim.core.field;

/**
 * Sine and cosine of one angle together. StrictMath's own make garbage for angles beyond an eighth
 * of a turn, so that these are turned back by quarters first (Cody &amp; Waite, Software Manual for
 * the Elementary Functions, 1980): exact to the last digits up to a million radians.
 */
final class Circle {
    private static final double QUARTERS = 2 / Math.PI;

    /** The first 33 bits of pi/2, so that products with whole numbers are exact; and the rest. */
    private static final double HIGH = 0x1.921fb544p0;

    private static final double LOW = 0x1.0b4611a626331p-34;

    private Circle() {}

    /** The nearest whole number of quarters of a turn to an angle (rad). */
    static double quarters(double angle) {
        return Math.rint(angle * QUARTERS);
    }

    /** What is left of the angle without them: an eighth of a turn at most, either way (rad). */
    static double rest(double angle, double quarters) {
        return angle - quarters * HIGH - quarters * LOW;
    }

    /**
     * The sine of an angle; its cosine with one quarter more.
     *
     * @param sin that of the rest
     * @param cos that of the rest
     */
    static double sine(double quarters, double sin, double cos) {
        long q = (long) quarters;
        double size = (q & 1) == 0 ? sin : cos;
        return (q & 2) == 0 ? size : -size;
    }
}
