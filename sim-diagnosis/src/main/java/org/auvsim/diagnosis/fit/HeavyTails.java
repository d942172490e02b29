package org.auvsim.diagnosis.fit;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * Takes their power from outliers: where a channel has more numbers far off than a normal
 * distribution has, each is weighed as under Student's t with few degrees of freedom (Lange, Little
 * &amp; Taylor 1989), by what it is off windows that follow the measurement whatever moves the body.
 */
final class HeavyTails {
    private static final double FREEDOM = 4;

    /** This far off (in standard deviations) 6 of 100,000 normally distributed numbers are. */
    private static final double FAR = 4;

    private static final double MOST_FAR = 0.002;

    private HeavyTails() {}

    /** The data of a fit, weighed where that is needed. */
    static List<Misses> tamed(Fit following) {
        List<double[]> misses = following.windowMisses();
        List<Misses> tamed = new ArrayList<>();
        for (int r = 0; r < misses.size(); r++) {
            Misses of = following.data().get(r);
            double[] factors = factors(of, misses.get(r));
            boolean changes = Arrays.stream(factors).anyMatch(f -> f != 1);
            tamed.add(changes ? of.weighed(factors) : of);
        }
        return tamed;
    }

    private static double[] factors(Misses of, double[] misses) {
        int rows = of.rows().size();
        double[] factors = new double[misses.length];
        Arrays.fill(factors, 1);
        for (int row = 0; row < rows; row++) {
            int far = 0;
            int count = 0;
            for (int i = row; i < misses.length; i += rows) {
                if (of.isMeasured(i)) {
                    count++;
                    far += Math.abs(misses[i]) > FAR ? 1 : 0;
                }
            }
            for (int i = row; far > MOST_FAR * count && i < misses.length; i += rows) {
                factors[i] = Math.sqrt((FREEDOM + 1) / (FREEDOM + misses[i] * misses[i]));
            }
        }
        return factors;
    }
}
