package org.auvsim.viz.scene;

/**
 * Follows a simulation that runs: while a step's states come, the time shown goes from the step
 * before to this one in as long as steps have lately taken to come. It shows a step late by one,
 * and so never stands still and never guesses.
 */
public final class LiveClock implements SceneClock {
    /** How much of the newest gap goes into the average. */
    private static final double WEIGHT = 0.1;

    /** Steps farther apart than this (s) were no stream. */
    private static final double PAUSE = 1;

    private double before;
    private double now;
    private long arrived;
    private double gap = 0.05;

    @Override
    public void stepDone(double time, long nanos) {
        double passed = (nanos - arrived) * 1e-9;
        if (passed < PAUSE) {
            gap += WEIGHT * (passed - gap);
        }
        before = Math.min(at(nanos), time);
        now = time;
        arrived = nanos;
    }

    @Override
    public void jump(double time) {
        before = time;
        now = time;
    }

    @Override
    public double at(long nanos) {
        double share = Math.clamp((nanos - arrived) * 1e-9 / Math.max(gap, 1e-3), 0, 1);
        return before + share * (now - before);
    }
}
