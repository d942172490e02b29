package org.auvsim.viz.window;

import org.auvsim.viz.drawing.Screen;

import java.awt.Canvas;
import java.awt.Color;
import java.awt.Component;
import java.awt.image.BufferedImage;
import java.util.concurrent.CompletableFuture;

/** A screen of one colour. */
final class FakeScreen implements Screen {
    private final Canvas canvas = new Canvas();

    FakeScreen() {
        canvas.setBackground(new Color(0x14344F));
        canvas.setName("screen");
    }

    @Override
    public Component component() {
        return canvas;
    }

    @Override
    public CompletableFuture<Void> start() {
        return CompletableFuture.completedFuture(null);
    }

    @Override
    public CompletableFuture<BufferedImage> picture() {
        return CompletableFuture.completedFuture(
                new BufferedImage(32, 24, BufferedImage.TYPE_INT_ARGB));
    }

    @Override
    public double frameRate() {
        return 60;
    }

    @Override
    public void close() {}
}
