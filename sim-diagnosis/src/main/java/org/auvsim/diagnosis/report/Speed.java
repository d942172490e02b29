package org.auvsim.diagnosis.report;

import org.auvsim.core.math.Vec3;
import org.auvsim.diagnosis.run.Channel;
import org.auvsim.diagnosis.run.MeasuredRun;

import java.util.Optional;

/** The measured speed of a run; where velocities were not measured, the slope of the positions. */
final class Speed {
    /** Slopes are taken over one part in this many of a run. */
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
        int from = Math.max(0, sample - reach);
        int to = Math.min(run.size() - 1, sample + reach);
        Optional<Vec3> first = run.vector(Channel.POSITION, from);
        Optional<Vec3> last = run.vector(Channel.POSITION, to);
        return first.isPresent() && last.isPresent()
                ? first.get().distance(last.get()) / (run.time(to) - run.time(from))
                : Double.NaN;
    }
}
