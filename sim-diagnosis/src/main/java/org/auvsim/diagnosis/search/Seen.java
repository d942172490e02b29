package org.auvsim.diagnosis.search;

import org.auvsim.diagnosis.model.Sensing;
import org.auvsim.diagnosis.run.Channel;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.run.Reading;

import java.util.HashSet;
import java.util.List;
import java.util.Set;

/**
 * What runs tell of a body while it was commanded: sensors that are late or ahead tell of a time
 * before the first row or after the last, when nobody knows what was commanded.
 */
final class Seen {
    private Seen() {}

    /** Runs without the numbers that are of such a time; the same ones, if there are none. */
    static List<MeasuredRun> of(List<MeasuredRun> runs, Sensing sensing) {
        return runs.stream().map(run -> of(run, sensing)).toList();
    }

    private static MeasuredRun of(MeasuredRun run, Sensing sensing) {
        Set<Reading> unseen = new HashSet<>();
        for (int k = 0; k < run.size(); k++) {
            double then = run.time(k) - sensing.delay();
            for (Channel channel : Channel.values()) {
                boolean isPlace = channel == Channel.POSITION;
                if (!isWithin(run, isPlace ? then - sensing.positionDelay() : then)) {
                    for (int axis = 0; axis < 3; axis++) {
                        unseen.add(new Reading(channel, k, axis));
                    }
                }
            }
        }
        return unseen.isEmpty() ? run : run.without(unseen);
    }

    private static boolean isWithin(MeasuredRun run, double time) {
        return time >= run.time(0) && time <= run.time(run.size() - 1);
    }
}
