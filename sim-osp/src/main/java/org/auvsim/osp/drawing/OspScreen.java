// SPDX-License-Identifier: GPL-2.0-or-later
package org.auvsim.osp.drawing;

import org.auvsim.viz.drawing.Painter;
import org.auvsim.viz.drawing.Screen;
import org.auvsim.viz.drawing.ScreenException;
import org.jspecify.annotations.Nullable;

import java.awt.Component;
import java.awt.Dimension;
import java.awt.Graphics;
import java.awt.image.BufferedImage;
import java.lang.reflect.InvocationTargetException;
import java.util.Queue;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ConcurrentLinkedQueue;

import javax.swing.JComponent;
import javax.swing.SwingUtilities;
import javax.swing.Timer;

/** A component that is painted up to 30 times a second, on the thread of the windows. */
final class OspScreen implements Screen {
    private static final int PERIOD = 33; // ms

    /** Frames a second are counted over so many of them. */
    private static final int COUNTED = 10;

    private final Canvas canvas = new Canvas();
    private final Timer timer = new Timer(PERIOD, _ -> frame());
    private final CompletableFuture<Void> started = new CompletableFuture<>();
    private final Queue<CompletableFuture<BufferedImage>> wanted = new ConcurrentLinkedQueue<>();
    private final Studio studio;
    private int frames;
    private long counted;
    private volatile double frameRate;
    private volatile boolean closed;

    OspScreen(Painter painter) {
        studio = new Studio(painter, 1);
        timer.setInitialDelay(0);
    }

    /** Shows the picture that was painted last. */
    private static final class Canvas extends JComponent {
        private static final long serialVersionUID = 1L;

        private transient @Nullable BufferedImage picture;

        Canvas() {
            setOpaque(true);
            setFocusable(true);
            setMinimumSize(new Dimension(1, 1));
        }

        @Override
        protected void paintComponent(Graphics graphics) {
            graphics.drawImage(picture, 0, 0, null);
        }
    }

    @Override
    public Component component() {
        return canvas;
    }

    @Override
    public CompletableFuture<Void> start() {
        counted = System.nanoTime();
        timer.start();
        return started;
    }

    private void frame() {
        if (closed || canvas.getWidth() == 0 || canvas.getHeight() == 0) {
            return;
        }
        BufferedImage picture = canvas.picture;
        if (picture == null
                || picture.getWidth() != canvas.getWidth()
                || picture.getHeight() != canvas.getHeight()) {
            picture =
                    new BufferedImage(
                            canvas.getWidth(), canvas.getHeight(), BufferedImage.TYPE_INT_RGB);
        }
        studio.paint(picture);
        canvas.picture = picture;
        canvas.repaint();
        count();
        started.complete(null);
        for (var next = wanted.poll(); next != null; next = wanted.poll()) {
            next.complete(copy(picture));
        }
    }

    private static BufferedImage copy(BufferedImage of) {
        BufferedImage copy = new BufferedImage(of.getWidth(), of.getHeight(), of.getType());
        copy.setData(of.getData());
        return copy;
    }

    private void count() {
        if (++frames % COUNTED == 0) {
            long now = System.nanoTime();
            frameRate = COUNTED * 1e9 / (now - counted);
            counted = now;
        }
    }

    @Override
    public CompletableFuture<BufferedImage> picture() {
        CompletableFuture<BufferedImage> next = new CompletableFuture<>();
        wanted.add(next);
        if (closed) {
            fail();
        }
        return next;
    }

    private void fail() {
        for (var next = wanted.poll(); next != null; next = wanted.poll()) {
            next.completeExceptionally(
                    new ScreenException("The window was closed before a picture was taken."));
        }
    }

    @Override
    public double frameRate() {
        return frameRate;
    }

    @Override
    public void close() {
        closed = true;
        timer.stop();
        if (!SwingUtilities.isEventDispatchThread()) {
            waitForFrame();
        }
        fail();
    }

    private static void waitForFrame() {
        try {
            SwingUtilities.invokeAndWait(() -> {});
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        } catch (InvocationTargetException e) {
            throw new IllegalStateException("nothing was to be done", e);
        }
    }
}
