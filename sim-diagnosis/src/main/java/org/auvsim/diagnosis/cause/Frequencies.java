package org.auvsim.diagnosis.cause;

import java.util.Arrays;

/**
 * Angular frequencies (rad/s) to begin with: as far apart as runs of this length can tell, or as
 * many as can be tried.
 */
final class Frequencies {
    private static final double LOWEST = 0.3;
    private static final double HIGHEST = 8;
    private static final int FEWEST = 40;
    private static final int MOST = 60;

    private final double duration;

    Frequencies(Setting s) {
        duration = s.path().duration();
    }

    Parameter parameter() {
        return new Parameter("omega", "rad/s", 1 / duration, 0.1 * LOWEST, 10 * HIGHEST);
    }

    double[] all() {
        double asFarAsTold = (HIGHEST - LOWEST) * duration / 3;
        return spread((int) Math.max(FEWEST, Math.min(MOST, asFarAsTold)));
    }

    /** Half as many: a search that begins at one of them still comes to those beside it. */
    double[] told(int fewest) {
        double asFarAsTold = (HIGHEST - LOWEST) * duration / 6;
        return spread((int) Math.max(fewest, Math.min(MOST, asFarAsTold)));
    }

    double[] spread(int count) {
        double[] all = new double[count];
        Arrays.setAll(all, i -> LOWEST + (HIGHEST - LOWEST) * i / (count - 1));
        return all;
    }
}
