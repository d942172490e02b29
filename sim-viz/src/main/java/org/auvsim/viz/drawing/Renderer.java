package org.auvsim.viz.drawing;

import java.awt.image.BufferedImage;

/**
 * A way to paint in three dimensions, found by {@link java.util.ServiceLoader} and chosen by its
 * name.
 */
public interface Renderer {
    /** Its name, as {@code jme}. */
    String name();

    /**
     * A screen for a window.
     *
     * @throws ScreenException if nothing can be shown on this machine
     */
    Screen screen(Painter painter) throws ScreenException;

    /**
     * One picture, without a window.
     *
     * @throws ScreenException if nothing can be painted on this machine
     */
    BufferedImage picture(Painter painter, int width, int height) throws ScreenException;
}
