package org.auvsim.viz.source;

import org.auvsim.viz.scene.Scene;

import java.util.Optional;
import java.util.concurrent.CompletableFuture;

/** Where a scene comes from. */
public interface Source extends AutoCloseable {
    /** What it shows. */
    Scene scene();

    /** Done when the scene has all objects that there were at the beginning. */
    default CompletableFuture<Void> ready() {
        return CompletableFuture.completedFuture(null);
    }

    /** Brings the scene to what is to be seen at an instant of the machine's clock (ns). */
    void bring(long nanos);

    /** What people are told about it, as {@code 127.0.0.1:40001, 12.5 s, running}. */
    String status();

    /** The simulator that can be steered; empty for a recording. */
    Optional<Steering> steering();

    /** The course of time that can be chosen; empty for a simulator. */
    Optional<Playback> playback();

    @Override
    void close();
}
