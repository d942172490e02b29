package org.auvsim.diagnosis.shooting;

import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.server.feedback.RigidMotion;

/**
 * A part of a run that is simulated from a start of its own.
 *
 * @param from its first sample
 * @param to the first sample of the next window, or the last of the run
 * @param start the motion at its first sample
 */
public record Window(int from, int to, RigidMotion start) {
    /** The same samples from another motion. */
    public Window startingAt(RigidMotion other) {
        return new Window(from, to, other);
    }

    /** How many samples it is long. */
    public int length() {
        return to - from;
    }

    /** How many of a run's samples are its own: the run's last one is that of the last window. */
    public int samples(MeasuredRun run) {
        return to == run.size() - 1 ? length() + 1 : length();
    }
}
