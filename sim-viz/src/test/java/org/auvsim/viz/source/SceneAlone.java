package org.auvsim.viz.source;

import org.auvsim.viz.scene.Scene;

import java.util.Optional;

/** A scene that a test writes by itself. */
public record SceneAlone(Scene scene) implements Source {
    @Override
    public void bring(long nanos) {}

    @Override
    public String status() {
        return "";
    }

    @Override
    public Optional<Steering> steering() {
        return Optional.empty();
    }

    @Override
    public Optional<Playback> playback() {
        return Optional.empty();
    }

    @Override
    public void close() {}
}
