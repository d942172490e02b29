package org.auvsim.viz.drawing;

import java.awt.Component;
import java.awt.image.BufferedImage;
import java.util.concurrent.CompletableFuture;

/** A picture that is painted again and again. */
public interface Screen extends AutoCloseable {
    /** What a window shows; add it, then {@link #start}. */
    Component component();

    /**
     * Begins to paint.
     *
     * @return done with the first frame; fails with a {@link ScreenException} if there can be none
     */
    CompletableFuture<Void> start();

    /** The next frame as it will be seen; fails with a {@link ScreenException}. */
    CompletableFuture<BufferedImage> picture();

    /** Frames a second, lately. */
    double frameRate();

    /** Fails with a {@link ScreenException} if painting breaks off; else it is never done. */
    default CompletableFuture<Void> failure() {
        return new CompletableFuture<>();
    }

    /** Ends painting and waits for its end; not from the Swing thread. */
    @Override
    void close();
}
