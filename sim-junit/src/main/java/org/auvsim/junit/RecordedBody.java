package org.auvsim.junit;

import java.util.ArrayList;
import java.util.List;

/**
 * Where a recording has a body after each step. Of one that rests nothing is told, so that it is
 * where it was; of a fixed one never anything, so that it has no poses.
 */
final class RecordedBody {
    private final List<Pose> poses = new ArrayList<>();
    private int revision;
    private long step;
    private boolean hasLeft;

    /** The body has moved in a step; where time went back, what was later is forgotten. */
    void moved(int revision, long step, Pose pose) {
        if (revision == this.revision) {
            rests(step - 1, before(step, pose.time()));
        }
        while (!poses.isEmpty() && poses.getLast().time() >= pose.time()) {
            poses.removeLast();
        }
        poses.add(pose);
        this.revision = revision;
        this.step = step;
    }

    /** The body went with a step: it was where it was up to the one before. */
    void left(long step, double time) {
        rests(step - 1, before(step, time));
        hasLeft = true;
    }

    /** When the step before was made, if those since the last pose took equal times. */
    private double before(long step, double time) {
        return poses.isEmpty() || step <= this.step
                ? time
                : time - (time - poses.getLast().time()) / (step - this.step);
    }

    /** The body has not moved up to a step. */
    void rests(long upTo, double time) {
        if (poses.isEmpty() || hasLeft) {
            return;
        }
        Pose pose = poses.getLast();
        long steps = upTo - step;
        for (long i = 1; i <= steps; i++) {
            double then = pose.time() + (time - pose.time()) * i / steps;
            poses.add(new Pose(then, pose.position(), pose.orientation()));
        }
        step = Math.max(step, upTo);
    }

    /** Its poses up to a time (s). */
    List<Pose> until(double time) {
        return poses.stream().filter(pose -> pose.time() <= time + Trajectory.SAME_TIME).toList();
    }
}
