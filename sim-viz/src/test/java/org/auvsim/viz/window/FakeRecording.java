package org.auvsim.viz.window;

import org.auvsim.viz.scene.Scene;
import org.auvsim.viz.source.Playback;
import org.auvsim.viz.source.Source;
import org.auvsim.viz.source.Steering;

import java.util.Optional;

/** A recording of 10 to 70 s in which nothing happens. */
final class FakeRecording implements Source, Playback {
    private final Scene scene;
    private double time = 10;
    private double rate = 1;
    private boolean isPlaying;

    FakeRecording(Scene scene) {
        this.scene = scene;
    }

    @Override
    public Scene scene() {
        return scene;
    }

    @Override
    public void bring(long nanos) {}

    @Override
    public String status() {
        return "a recording";
    }

    @Override
    public Optional<Steering> steering() {
        return Optional.empty();
    }

    @Override
    public Optional<Playback> playback() {
        return Optional.of(this);
    }

    @Override
    public void close() {}

    @Override
    public double start() {
        return 10;
    }

    @Override
    public double end() {
        return 70;
    }

    @Override
    public synchronized double time() {
        return time;
    }

    @Override
    public synchronized void seek(double other) {
        time = other;
    }

    @Override
    public synchronized void step(int steps) {
        time += steps * 0.5;
    }

    @Override
    public synchronized boolean isPlaying() {
        return isPlaying;
    }

    @Override
    public synchronized void play(boolean on) {
        isPlaying = on;
    }

    @Override
    public synchronized double rate() {
        return rate;
    }

    @Override
    public synchronized void rate(double other) {
        rate = other;
    }
}
