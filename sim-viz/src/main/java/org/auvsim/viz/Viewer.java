package org.auvsim.viz;

import org.auvsim.viz.camera.OrbitCamera;
import org.auvsim.viz.drawing.Renderer;
import org.auvsim.viz.drawing.SceneDrawing;
import org.auvsim.viz.drawing.ScreenException;
import org.auvsim.viz.drawing.ViewOptions;
import org.auvsim.viz.source.Source;
import org.auvsim.viz.window.ViewerWindow;

import java.awt.GraphicsEnvironment;
import java.awt.image.BufferedImage;
import java.util.concurrent.ExecutionException;

/** Shows what a source has, in a window or as a picture. */
public final class Viewer {
    private final OrbitCamera camera = new OrbitCamera();
    private final ViewOptions options = new ViewOptions();
    private final Source source;
    private final Renderer renderer;

    /** A viewer of a source, painted by a renderer; the source stays the caller's. */
    public Viewer(Source source, Renderer renderer) {
        this.source = source;
        this.renderer = renderer;
    }

    /**
     * One picture of how things stand now.
     *
     * @throws ScreenException if nothing can be painted on this machine
     */
    public BufferedImage picture(ViewStart start, int width, int height) throws ScreenException {
        prepare(start);
        return renderer.picture(new SceneDrawing(source, options, camera), width, height);
    }

    /**
     * A window; returns when it is closed.
     *
     * @throws ScreenException if none can be shown on this machine
     */
    public void show(ViewStart start) throws ScreenException {
        if (GraphicsEnvironment.isHeadless()) {
            throw new ScreenException(
                    "There is no display here: set DISPLAY, use 'auvsim watch', or --picture FILE with"
                            + " --renderer osp, which paints without one.");
        }
        prepare(start);
        ViewerWindow.show(source, options, camera, renderer);
    }

    private void prepare(ViewStart start) throws ScreenException {
        try {
            source.ready().get();
        } catch (ExecutionException e) {
            throw new ScreenException(String.valueOf(e.getCause()), e);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new ScreenException("Nothing was shown: interrupted.", e);
        }
        source.bring(System.nanoTime());
        start.apply(source.scene(), options, camera);
    }
}
