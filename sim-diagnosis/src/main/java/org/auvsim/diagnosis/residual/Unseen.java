package org.auvsim.diagnosis.residual;

import org.auvsim.diagnosis.model.Sensing;
import org.auvsim.diagnosis.run.Channel;
import org.auvsim.diagnosis.run.MeasuredRun;

/**
 * What sensors that are late tell of times before the first row of a run, and those that are ahead
 * of times after its last: when nobody knows what was done to the body, or how it was held. Motions
 * go on evenly there, as that of a vehicle at rest does, but not that of a ball.
 */
final class Unseen {
    /** Mean squares of what is beyond a run that are more than noise. */
    private static final double MOST_OF_NOISE = 2;

    /** At least the rest of a run must be seen: of less, a late sensor could tell anything. */
    private static final double MOST = 0.25;

    private Unseen() {}

    /**
     * Which numbers, row by row within each sample, are beyond the run and missed by more than
     * noise; none if that would be too much of it.
     *
     * @param misses of all samples
     */
    static boolean[] of(Misses all, Sensing sensing, double[] misses) {
        boolean[] unseen = new boolean[misses.length];
        double sum = 0;
        int count = 0;
        for (int i = 0; i < misses.length; i++) {
            if (all.isMeasured(i) && !isWithin(all, sensing, i)) {
                unseen[i] = true;
                sum += misses[i] * misses[i];
                count++;
            }
        }
        boolean areMissed = sum > MOST_OF_NOISE * count && count <= MOST * all.count();
        return areMissed ? unseen : new boolean[misses.length];
    }

    private static boolean isWithin(Misses all, Sensing sensing, int index) {
        MeasuredRun run = all.run();
        Channel channel = all.rows().get(index % all.rows().size()).channel();
        double then = run.time(index / all.rows().size()) - sensing.age(channel);
        return then >= run.time(0) && then <= run.time(run.size() - 1);
    }
}
