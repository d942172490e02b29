package org.auvsim.viz.source;

import org.auvsim.viz.scene.Scene;

import java.util.Optional;

/** Where a scene comes from. */
public interface Source extends AutoCloseable {
    /** What it shows. */
    Scene scene();

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
