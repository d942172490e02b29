package org.auvsim.diagnosis.cause;

import java.util.Arrays;
import java.util.stream.IntStream;

/**
 * Angular frequencies (rad/s) to begin with: as far apart as runs of this length can tell, or as
 * many as can be tried.
 */
final class Frequencies {
    private static final double LOWEST = 0.3;
    private static final double HIGHEST = 8;
    private static final int FEWEST = 40;
    private static final int MOST = 120;

    /** The same where each is tried in several ways. */
    private static final int MOST_TOLD = 60;

    /** Steps in which the phase between the first and the last run turns once. */
    private static final int PER_TURN = 4;

    private static final int MOST_ALIASES = 80;

    private final double duration;
    private final double span;

    Frequencies(Setting s) {
        duration = s.path().duration();
        span = s.path().end() - s.path().begin();
    }

    Parameter parameter() {
        return new Parameter(Quantity.FREQUENCY, "rad/s", 1 / duration, 0.1 * LOWEST, 10 * HIGHEST);
    }

    double[] all() {
        double asFarAsTold = (HIGHEST - LOWEST) * duration / 3;
        return spread((int) Math.max(FEWEST, Math.min(MOST, asFarAsTold)));
    }

    /** Half as many: a search that begins at one of them still comes to those beside it. */
    double[] told(int fewest) {
        double asFarAsTold = (HIGHEST - LOWEST) * duration / 6;
        return spread((int) Math.max(fewest, Math.min(MOST_TOLD, asFarAsTold)));
    }

    /**
     * Those that no run by itself tells from one, so far apart as all of them together can; none if
     * the runs are not far apart.
     */
    double[] aliases(double omega) {
        if (span < 2 * duration) {
            return new double[0];
        }
        double apart = 2 * Math.PI / (PER_TURN * span);
        int most = (int) Math.min(MOST_ALIASES, Math.ceil(PER_TURN * span / duration));
        return IntStream.rangeClosed(-most, most)
                .mapToDouble(i -> omega + i * apart)
                .filter(alias -> alias > 0)
                .toArray();
    }

    double[] spread(int count) {
        double[] all = new double[count];
        Arrays.setAll(all, i -> LOWEST + (HIGHEST - LOWEST) * i / (count - 1));
        return all;
    }
}
