package org.auvsim.viz.jme;

import static java.util.Objects.requireNonNull;

import com.jme3.app.LegacyApplication;
import com.jme3.app.state.AppState;
import com.jme3.math.ColorRGBA;
import com.jme3.renderer.queue.RenderQueue.Bucket;
import com.jme3.scene.Node;
import com.jme3.system.AppSettings;

import org.auvsim.viz.drawing.Painter;
import org.auvsim.viz.drawing.ScreenException;
import org.jspecify.annotations.Nullable;

import java.awt.image.BufferedImage;
import java.util.concurrent.CompletableFuture;

/**
 * jMonkeyEngine's loop: each frame asks the painter for what there is. It paints and nothing else;
 * keys and mouse belong to the window.
 */
final class JmeApplication extends LegacyApplication {
    /** Who does not end within this (ms) is left behind. */
    private static final long PATIENCE = 5_000;

    /** Frames a second are counted over so many of them. */
    private static final int COUNTED = 30;

    private final Painter painter;
    private final CompletableFuture<Void> started = new CompletableFuture<>();
    private final CompletableFuture<Thread> paintingThread = new CompletableFuture<>();
    private final CompletableFuture<Void> failure = new CompletableFuture<>();
    private final JmeCamera eye = new JmeCamera();
    private final ColorRGBA background = new ColorRGBA();
    private final Node words = new Node("words");
    private @Nullable JmeBrush brush;
    private @Nullable Snapshots snapshots;
    private int frames;
    private long counted;
    private volatile double frameRate;

    JmeApplication(Painter painter, int width, int height) {
        super(new AppState[0]);
        this.painter = painter;
        AppSettings wanted = new AppSettings(true);
        wanted.setRenderer(AppSettings.LWJGL_OPENGL32);
        wanted.setAudioRenderer(null);
        wanted.setX11PlatformPreferred(true);
        wanted.setUseInput(false);
        wanted.setUseJoysticks(false);
        wanted.setGammaCorrection(false);
        wanted.setFrameRate(60);
        wanted.setVSync(false);
        wanted.setWidth(width);
        wanted.setHeight(height);
        setSettings(wanted);
        setPauseOnLostFocus(false);
    }

    CompletableFuture<Void> started() {
        return started;
    }

    /**
     * Ends it and waits until nothing of it is left: another one that began earlier would find the
     * windowing library closed under its feet.
     */
    void end() throws InterruptedException {
        stop();
        if (paintingThread.isDone()) {
            paintingThread.join().join(PATIENCE);
        }
    }

    CompletableFuture<Void> failure() {
        return failure;
    }

    double frameRate() {
        return frameRate;
    }

    /** The next frame. */
    CompletableFuture<BufferedImage> picture() {
        return started.thenCompose(_ -> requireNonNull(snapshots).next());
    }

    @Override
    public void initialize() {
        super.initialize();
        paintingThread.complete(Thread.currentThread());
        JmeBrush made = new JmeBrush(assetManager, painter.camera());
        brush = made;
        viewPort.attachScene(made.node());
        words.setQueueBucket(Bucket.Gui);
        words.attachChild(made.words());
        guiViewPort.attachScene(words);
        Snapshots grabber = new Snapshots(renderManager);
        snapshots = grabber;
        guiViewPort.addProcessor(grabber);
    }

    @Override
    public void update() {
        super.update();
        paint(requireNonNull(brush));
        stateManager.update(0);
        stateManager.render(renderManager);
        renderManager.render(0, context.isRenderable());
        stateManager.postRender();
        count();
        started.complete(null);
    }

    private void paint(JmeBrush to) {
        int colour = painter.background();
        background.set(
                (colour >> 16 & 0xff) / 255f,
                (colour >> 8 & 0xff) / 255f,
                (colour & 0xff) / 255f,
                1);
        viewPort.setBackgroundColor(background);
        to.begin(cam.getWidth(), cam.getHeight());
        painter.paint(to, System.nanoTime());
        to.end();
        eye.apply(painter.camera(), to, cam);
        to.node().updateLogicalState(0);
        to.node().updateGeometricState();
        words.updateLogicalState(0);
        words.updateGeometricState();
    }

    private void count() {
        if (++frames % COUNTED == 0) {
            long now = System.nanoTime();
            frameRate = COUNTED * 1e9 / (now - counted);
            counted = now;
        }
    }

    @Override
    public void handleError(String what, Throwable why) {
        paintingThread.complete(Thread.currentThread());
        boolean never =
                started.completeExceptionally(
                        new ScreenException(
                                ("Three dimensions cannot be shown here, as there is no display"
                                     + " with OpenGL 3.2: %s. Install a graphics driver, use"
                                     + " --renderer osp, which needs no OpenGL (docs/osp.md), or"
                                     + " 'auvsim watch', which needs no display.")
                                        .formatted(cause(what, why)),
                                why));
        if (!never) {
            failure.completeExceptionally(
                    new ScreenException(
                            "The picture cannot be painted any more: %s."
                                    .formatted(cause(what, why)),
                            why));
        }
        stop();
    }

    private static String cause(String what, Throwable why) {
        String message = why == null || why.getMessage() == null ? what : why.getMessage();
        return message.lines().findFirst().orElse("no reason is given").strip();
    }

    @Override
    public void destroy() {
        super.destroy();
        if (snapshots != null) {
            snapshots.fail(
                    new ScreenException("The window was closed before a picture was taken."));
        }
    }
}
