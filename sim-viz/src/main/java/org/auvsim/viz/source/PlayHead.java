package org.auvsim.viz.source;

/**
 * Where in a recording it is shown. Its lock is held for reckoning alone, so that nobody who asks
 * has to wait for a scene.
 */
final class PlayHead implements Playback {
    private final Times steps;
    private double time;
    private double rate = 1;
    private boolean playing;
    private boolean asked;
    private long lastAsked;

    /** Stands at the first of these instants, which do not change any more. */
    PlayHead(Times steps) {
        this.steps = steps;
        this.time = steps.first();
    }

    /** The time (s) to show at an instant of the machine's clock (ns). */
    synchronized double advance(long nanos) {
        double passed = asked ? Math.max(nanos - lastAsked, 0) * 1e-9 : 0;
        asked = true;
        lastAsked = nanos;
        if (playing) {
            time = Math.min(time + rate * passed, end());
            playing = time < end();
        }
        return time;
    }

    @Override
    public double start() {
        return steps.first();
    }

    @Override
    public double end() {
        return steps.newest();
    }

    @Override
    public synchronized double time() {
        return time;
    }

    @Override
    public synchronized void seek(double to) {
        if (Double.isNaN(to)) {
            throw new IllegalArgumentException("a time to show must be a number, but is NaN");
        }
        time = Math.clamp(to, start(), end());
    }

    @Override
    public synchronized void step(int count) {
        playing = false;
        int at = steps.at(time);
        boolean between = steps.get(at) < time;
        long to = (long) at + count + (between && count < 0 ? 1 : 0);
        time = steps.get(Math.clamp(to, 0, steps.count() - 1));
    }

    @Override
    public synchronized boolean isPlaying() {
        return playing;
    }

    @Override
    public synchronized void play(boolean on) {
        if (on && time >= end()) {
            time = start();
        }
        playing = on;
    }

    @Override
    public synchronized double rate() {
        return rate;
    }

    @Override
    public synchronized void rate(double other) {
        if (!(other > 0) || Double.isInfinite(other)) {
            throw new IllegalArgumentException(
                    "the rate must be above 0 and finite, but is " + other);
        }
        rate = other;
    }
}
