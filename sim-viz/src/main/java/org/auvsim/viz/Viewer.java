package org.auvsim.viz;

import org.auvsim.viz.camera.OrbitCamera;
import org.auvsim.viz.drawing.Renderer;
import org.auvsim.viz.drawing.SceneDrawing;
import org.auvsim.viz.drawing.Screen;
import org.auvsim.viz.drawing.ScreenException;
import org.auvsim.viz.drawing.ViewOptions;
import org.auvsim.viz.driving.Gamepad;
import org.auvsim.viz.driving.GlfwGamepad;
import org.auvsim.viz.scene.Occurrence;
import org.auvsim.viz.source.Source;
import org.auvsim.viz.window.ViewerWindow;

import java.awt.AWTError;
import java.awt.GraphicsEnvironment;
import java.awt.HeadlessException;
import java.awt.image.BufferedImage;
import java.lang.reflect.InvocationTargetException;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;

import javax.swing.SwingUtilities;

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
        requireDisplay();
        prepare(start);
        try {
            CompletableFuture<Void> closed = new CompletableFuture<>();
            Opened opened = open(closed);
            try {
                opened.started().get();
                CompletableFuture.anyOf(closed, opened.screen().failure()).get();
            } finally {
                SwingUtilities.invokeAndWait(opened.window()::close);
                opened.screen().close();
            }
        } catch (ExecutionException | InvocationTargetException e) {
            throw explained(e);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new ScreenException("The window was closed: interrupted.", e);
        } catch (AWTError e) {
            throw noDisplay(e);
        }
    }

    /**
     * Finds out whether there is a display for a window.
     *
     * @throws ScreenException if there is none
     */
    public static void requireDisplay() throws ScreenException {
        try {
            if (GraphicsEnvironment.isHeadless()) {
                throw new HeadlessException("no screen is connected");
            }
            GraphicsEnvironment.getLocalGraphicsEnvironment().getDefaultScreenDevice();
        } catch (AWTError | HeadlessException e) {
            throw noDisplay(e);
        }
    }

    private record Opened(ViewerWindow window, Screen screen, CompletableFuture<Void> started) {}

    private Opened open(CompletableFuture<Void> closed)
            throws InterruptedException, InvocationTargetException, ExecutionException {
        CompletableFuture<Opened> opened = new CompletableFuture<>();
        SwingUtilities.invokeAndWait(
                () -> {
                    try {
                        opened.complete(openInSwing(closed));
                    } catch (ScreenException e) {
                        opened.completeExceptionally(e);
                    }
                });
        return opened.get();
    }

    private Opened openInSwing(CompletableFuture<Void> closed) throws ScreenException {
        Screen screen = renderer.screen(new SceneDrawing(source, options, camera));
        Gamepad gamepad =
                GlfwGamepad.open(
                        words -> source.scene().tell(new Occurrence(source.scene().time(), words)));
        ViewerWindow window =
                new ViewerWindow(
                        source, camera, screen, options, gamepad, () -> closed.complete(null));
        return new Opened(window, screen, window.show());
    }

    private static ScreenException explained(Exception e) {
        return switch (e.getCause()) {
            case ScreenException known -> known;
            case AWTError none -> noDisplay(none);
            case HeadlessException none -> noDisplay(none);
            case null, default ->
                    new ScreenException("The window cannot be shown: " + sentence(e) + ".", e);
        };
    }

    /** What the innermost cause says. */
    private static String sentence(Throwable failure) {
        Throwable inner = failure;
        while (inner.getCause() != null) {
            inner = inner.getCause();
        }
        return inner.getMessage() == null ? inner.toString() : inner.getMessage();
    }

    private static ScreenException noDisplay(Throwable e) {
        return new ScreenException(
                ("There is no display here (%s): set DISPLAY, use 'auvsim watch', or --picture FILE"
                                + " with --renderer osp, which paints without one (docs/osp.md).")
                        .formatted(firstLine(e)),
                e);
    }

    /** What a failure says first, without a full stop. */
    private static String firstLine(Throwable e) {
        String line = String.valueOf(e.getMessage()).lines().findFirst().orElse("").strip();
        return line.endsWith(".") ? line.substring(0, line.length() - 1) : line;
    }

    private void prepare(ViewStart start) throws ScreenException {
        try {
            source.ready().get();
        } catch (ExecutionException e) {
            throw new ScreenException(sentence(e), e);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new ScreenException("Nothing was shown: interrupted.", e);
        }
        source.bring(System.nanoTime());
        start.apply(source.scene(), options, camera);
    }
}
