package org.auvsim.core.field;

/** How long a wave of water is (Airy 1845; Dean &amp; Dalrymple, Water Wave Mechanics, 1991). */
final class Dispersion {
    /** Standard gravity (m/s^2), CGPM 1901. */
    static final double GRAVITY = 9.80665;

    private static final int MOST_ROUNDS = 30;

    private Dispersion() {}

    /**
     * The wave number k (rad/m) of omega^2 = g k tanh(k depth): Newton's method from Eckart's
     * approximation (1952), which is off by 5 % at most.
     *
     * @param omega angular frequency (rad/s), above 0
     * @param depth of the water (m), above 0; infinite for deep water
     */
    static double wavenumber(double omega, double depth) {
        double deep = omega * omega / GRAVITY;
        double alpha = deep * depth;
        if (alpha > 40) {
            return deep;
        }
        double y = alpha / Math.sqrt(StrictMath.tanh(alpha));
        double change = y;
        for (int round = 0; round < MOST_ROUNDS && Math.abs(change) > 1e-15 * y; round++) {
            double tanh = StrictMath.tanh(y);
            change = (y * tanh - alpha) / (tanh + y * (1 - tanh * tanh));
            y -= change;
        }
        return y / depth;
    }
}
