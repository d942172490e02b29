package org.auvsim.diagnosis.shaking;

/**
 * How much a body shakes, compared with runs that are known to be sound.
 *
 * @param factor how many times as much as in those
 * @param deviation its standard deviation, as sound runs scatter
 * @param limit what sound runs exceed once in a hundred times
 * @param statistic by how much it is more, in standard deviations of what sound runs would have
 * @param references how many runs it is compared with
 * @param runs how many runs are compared
 */
public record Shaking(
        double factor, double deviation, double limit, double statistic, int references, int runs) {
    /** Whether it is more than sound runs have by chance. */
    public boolean isTooMuch() {
        return factor > limit;
    }

    /**
     * By how much the logarithm of the evidence is more with another shaking than with that of the
     * reference runs (Schwarz 1978, for the means of two normal samples).
     */
    double logEvidence() {
        double samples = references + runs;
        double square = statistic * statistic / (references - 1);
        return samples / 2 * StrictMath.log1p(square) - StrictMath.log(samples) / 2;
    }
}
