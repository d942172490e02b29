package org.auvsim.diagnosis.reading;

import org.auvsim.diagnosis.run.Channel;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.run.Reading;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;

/** Numbers of a run that count as not measured, and what is told of them. */
final class LeftOut {
    private static final int AXES = 3;

    private final MeasuredRun run;
    private final Set<Reading> readings = new HashSet<>();
    private final List<String> notices = new ArrayList<>();

    /** None yet. */
    LeftOut(MeasuredRun run) {
        this.run = run;
    }

    /** Looks at the numbers of a channel along or about an axis (0 to 2). */
    interface Look {
        void at(Channel channel, int axis);
    }

    /** Looks at all axes of some channels. */
    LeftOut lookingAt(List<Channel> channels, Look look) {
        for (Channel channel : channels) {
            for (int axis = 0; axis < AXES; axis++) {
                look.at(channel, axis);
            }
        }
        return this;
    }

    /** One more. */
    void add(Channel channel, int sample, int axis) {
        readings.add(new Reading(channel, sample, axis));
    }

    void tell(String notice) {
        notices.add(notice);
    }

    /** The run without them; itself, if there are none. */
    MeasuredRun without() {
        return readings.isEmpty() ? run : run.without(readings);
    }

    /** What is told of them. */
    List<String> notices() {
        return List.copyOf(notices);
    }
}
