package org.auvsim.core.field;

/**
 * The energy of a sea by frequency, as JONSWAP has measured it (Hasselmann et al. 1973, in the form
 * of DNV-RP-C205, section 3.5.5); without the peak's enhancement it is that of Pierson and
 * Moskowitz (1964). It is given up to a factor, which the significant height decides.
 *
 * @param peak angular frequency (rad/s)
 * @param gamma by how much the peak is enhanced
 */
record Spectrum(double peak, double gamma) {
    /**
     * Below and above this share of the peak's frequency there is less than 0.5 % of the energy.
     */
    private static final double LOWEST = 0.5;

    private static final double HIGHEST = 4;

    private double density(double omega) {
        double ratio = peak / omega;
        double width = omega <= peak ? 0.07 : 0.09;
        double offset = (omega - peak) / (width * peak);
        double quartic = ratio * ratio * ratio * ratio;
        return quartic
                * ratio
                * StrictMath.exp(-1.25 * quartic)
                * StrictMath.pow(gamma, StrictMath.exp(-offset * offset / 2));
    }

    /**
     * Frequencies (rad/s), one drawn in each of as many bands of equal width, so that the sea does
     * not repeat itself.
     */
    double[] frequencies(int count, Draw draw) {
        double[] omega = new double[count];
        double width = (HIGHEST - LOWEST) * peak / count;
        for (int n = 0; n < count; n++) {
            omega[n] = LOWEST * peak + (n + draw.next()) * width;
        }
        return omega;
    }

    /** Amplitudes (m) of waves of these frequencies; the sum of a^2/2 is height^2/16. */
    double[] amplitudes(double[] omega, double significantHeight) {
        double[] amplitude = new double[omega.length];
        double sum = 0;
        for (int n = 0; n < omega.length; n++) {
            double density = density(omega[n]);
            amplitude[n] = Math.sqrt(density);
            sum += density;
        }
        double scale = significantHeight / Math.sqrt(8 * sum);
        for (int n = 0; n < omega.length; n++) {
            amplitude[n] *= scale;
        }
        return amplitude;
    }
}
