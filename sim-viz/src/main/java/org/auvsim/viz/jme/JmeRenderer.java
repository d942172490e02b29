package org.auvsim.viz.jme;

import com.jme3.system.JmeContext;

import org.auvsim.viz.drawing.Painter;
import org.auvsim.viz.drawing.Renderer;
import org.auvsim.viz.drawing.Screen;
import org.auvsim.viz.drawing.ScreenException;
import org.slf4j.bridge.SLF4JBridgeHandler;

import java.awt.image.BufferedImage;
import java.util.concurrent.ExecutionException;

/** Paints with jMonkeyEngine (jmonkeyengine.org), by OpenGL 3.2 or later. */
public final class JmeRenderer implements Renderer {
    private static final int WIDTH = 960;
    private static final int HEIGHT = 640;

    /** Found by {@link java.util.ServiceLoader}. */
    public JmeRenderer() {
        // Its notes go where the program's own go, if anywhere.
        if (!SLF4JBridgeHandler.isInstalled()) {
            SLF4JBridgeHandler.removeHandlersForRootLogger();
            SLF4JBridgeHandler.install();
        }
    }

    @Override
    public String name() {
        return "jme";
    }

    @Override
    public Screen screen(Painter painter) {
        return new JmeScreen(new JmeApplication(painter, WIDTH, HEIGHT));
    }

    @Override
    public BufferedImage picture(Painter painter, int width, int height) throws ScreenException {
        JmeApplication application = new JmeApplication(painter, width, height);
        application.start(JmeContext.Type.OffscreenSurface, false);
        try {
            try {
                return application.picture().get();
            } catch (ExecutionException e) {
                throw e.getCause() instanceof ScreenException known
                        ? known
                        : new ScreenException("The picture could not be painted: " + e, e);
            } finally {
                application.end();
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new ScreenException("The picture was not painted: interrupted.", e);
        }
    }
}
