package org.auvsim.core.actuator;

import org.auvsim.core.math.Exponentials;

/**
 * A level that follows its target with a first-order lag: x(s) = target + (from - target)
 * exp(-s/lag) after s seconds; at once without a lag.
 */
record Lag(double from, double target, double lag) {
    private static final double SETTLED = 40;

    /** The level where so much is {@link #left}. */
    double level(double left) {
        return level(from, target, left);
    }

    /** The same of one that is asked for nothing else, and so need not be made. */
    static double level(double from, double target, double left) {
        return target + (from - target) * left;
    }

    /** By how much the level rises (1/s) where so much is {@link #left}. */
    double slope(double left) {
        return lag == 0 ? 0 : (target - from) / lag * left;
    }

    /** The share of the way to the target that is left after so many seconds; 0 below rounding. */
    static double left(double lag, double after) {
        return isOver(lag, after) ? 0 : StrictMath.exp(exponent(lag, after));
    }

    /** The same of many bodies that may have the same lag. */
    static double left(double lag, double after, Exponentials known) {
        return isOver(lag, after) ? 0 : known.exp(exponent(lag, after));
    }

    private static boolean isOver(double lag, double after) {
        return lag == 0 || after >= SETTLED * lag;
    }

    private static double exponent(double lag, double after) {
        return -Math.max(after, 0) / lag;
    }

    /** The integral of |level|^3 over so many seconds (s), in closed form. */
    double cubeIntegral(double seconds) {
        if (lag == 0 || from == target) {
            return Math.abs(target * target * target) * seconds;
        }
        if (from * target >= 0) {
            return Math.abs(signedCubeIntegral(seconds));
        }
        double zero = lag * StrictMath.log((from - target) / -target);
        if (zero >= seconds) {
            return Math.abs(signedCubeIntegral(seconds));
        }
        double first = signedCubeIntegral(zero);
        return Math.abs(first) + Math.abs(signedCubeIntegral(seconds) - first);
    }

    /** Of (target + d e^(-s/lag))^3, term by term of the binomial. */
    private double signedCubeIntegral(double seconds) {
        double d = from - target;
        double gone1 = -StrictMath.expm1(-seconds / lag);
        double gone2 = -StrictMath.expm1(-2 * seconds / lag);
        double gone3 = -StrictMath.expm1(-3 * seconds / lag);
        return target * target * target * seconds
                + 3 * target * target * d * lag * gone1
                + 3 * target * d * d * lag / 2 * gone2
                + d * d * d * lag / 3 * gone3;
    }
}
