package org.auvsim.diagnosis.report;

import org.auvsim.core.math.Vec3;
import org.auvsim.diagnosis.run.Channel;
import org.auvsim.diagnosis.run.MeasuredRun;

import java.util.OptionalInt;

/** The measured speed of a run; where velocities were not measured, the slope of the positions. */
final class Speed {
    /** Slopes are taken over one part in this many of a run, or from one position to the next. */
    private static final int SHARE = 60;

    private final MeasuredRun run;
    private final int reach;

    Speed(MeasuredRun run) {
        this.run = run;
        this.reach = Math.max(1, run.size() / SHARE / 2);
    }

    boolean isMeasured() {
        return measures(Channel.VELOCITY);
    }

    boolean isKnown() {
        return isMeasured() || measures(Channel.POSITION);
    }

    private boolean measures(Channel channel) {
        return run.measures(channel, 0) && run.measures(channel, 1) && run.measures(channel, 2);
    }

    /** NaN where it is not known (m/s). */
    double at(int sample) {
        if (isMeasured()) {
            return run.vector(Channel.VELOCITY, sample).map(Vec3::norm).orElse(Double.NaN);
        }
        if (run.vector(Channel.POSITION, sample).isEmpty()) {
            return Double.NaN;
        }
        int from = placed(Math.max(0, sample - reach), -1).orElse(sample);
        int to = placed(Math.min(run.size() - 1, sample + reach), 1).orElse(sample);
        return from == to
                ? Double.NaN
                : place(from).distance(place(to)) / (run.time(to) - run.time(from));
    }

    /** The nearest sample with a position from one on, backwards or forwards; none at the end. */
    private OptionalInt placed(int from, int step) {
        for (int k = from; k >= 0 && k < run.size(); k += step) {
            if (run.vector(Channel.POSITION, k).isPresent()) {
                return OptionalInt.of(k);
            }
        }
        return OptionalInt.empty();
    }

    private Vec3 place(int sample) {
        return run.vector(Channel.POSITION, sample).orElseThrow();
    }
}
