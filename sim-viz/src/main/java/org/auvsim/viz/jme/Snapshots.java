package org.auvsim.viz.jme;

import com.jme3.post.SceneProcessor;
import com.jme3.profile.AppProfiler;
import com.jme3.renderer.RenderManager;
import com.jme3.renderer.ViewPort;
import com.jme3.renderer.queue.RenderQueue;
import com.jme3.texture.FrameBuffer;
import com.jme3.util.BufferUtils;

import java.awt.image.BufferedImage;
import java.nio.ByteBuffer;
import java.util.ArrayDeque;
import java.util.Queue;
import java.util.concurrent.CompletableFuture;

/** Reads frames back from the graphics card for those who ask. */
final class Snapshots implements SceneProcessor {
    private final Queue<CompletableFuture<BufferedImage>> wanted = new ArrayDeque<>();
    private RenderManager manager;
    private int width;
    private int height;

    Snapshots(RenderManager manager) {
        this.manager = manager;
    }

    /** The next frame. */
    CompletableFuture<BufferedImage> next() {
        CompletableFuture<BufferedImage> picture = new CompletableFuture<>();
        synchronized (wanted) {
            wanted.add(picture);
        }
        return picture;
    }

    @Override
    public void initialize(RenderManager renderManager, ViewPort port) {
        manager = renderManager;
        reshape(port, port.getCamera().getWidth(), port.getCamera().getHeight());
    }

    @Override
    public void reshape(ViewPort port, int wide, int high) {
        width = wide;
        height = high;
    }

    @Override
    public boolean isInitialized() {
        return width > 0;
    }

    @Override
    public void preFrame(float passed) {
        // Nothing is needed before.
    }

    @Override
    public void postQueue(RenderQueue queue) {
        // Nothing is needed between.
    }

    @Override
    public void postFrame(FrameBuffer out) {
        synchronized (wanted) {
            if (wanted.isEmpty()) {
                return;
            }
            BufferedImage picture = read(out);
            wanted.forEach(each -> each.complete(picture));
            wanted.clear();
        }
    }

    /** Rows come from the bottom up, a pixel's red first. */
    private BufferedImage read(FrameBuffer out) {
        ByteBuffer pixels = BufferUtils.createByteBuffer(4 * width * height);
        manager.getRenderer().readFrameBuffer(out, pixels);
        BufferedImage picture = new BufferedImage(width, height, BufferedImage.TYPE_INT_RGB);
        for (int y = 0; y < height; y++) {
            for (int x = 0; x < width; x++) {
                int at = 4 * ((height - 1 - y) * width + x);
                picture.setRGB(
                        x,
                        y,
                        (pixels.get(at) & 0xff) << 16
                                | (pixels.get(at + 1) & 0xff) << 8
                                | (pixels.get(at + 2) & 0xff));
            }
        }
        BufferUtils.destroyDirectBuffer(pixels);
        return picture;
    }

    /** There will be no frame any more. */
    void fail(Exception why) {
        synchronized (wanted) {
            wanted.forEach(each -> each.completeExceptionally(why));
            wanted.clear();
        }
    }

    @Override
    public void cleanup() {
        // Nothing is kept.
    }

    @Override
    public void setProfiler(AppProfiler profiler) {
        // Not profiled.
    }
}
