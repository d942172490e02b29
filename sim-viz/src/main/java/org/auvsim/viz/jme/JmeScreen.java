package org.auvsim.viz.jme;

import com.jme3.system.JmeCanvasContext;

import org.auvsim.viz.drawing.Screen;

import java.awt.Canvas;
import java.awt.Component;
import java.awt.Dimension;
import java.awt.image.BufferedImage;
import java.util.concurrent.CompletableFuture;

/** jMonkeyEngine's canvas in a window. */
final class JmeScreen implements Screen {
    private final JmeApplication application;
    private final Canvas canvas;

    JmeScreen(JmeApplication application) {
        this.application = application;
        application.createCanvas();
        JmeCanvasContext context = (JmeCanvasContext) application.getContext();
        context.setSystemListener(application);
        canvas = context.getCanvas();
        canvas.setMinimumSize(new Dimension(1, 1));
    }

    @Override
    public Component component() {
        return canvas;
    }

    @Override
    public CompletableFuture<Void> start() {
        application.startCanvas();
        return application.started();
    }

    @Override
    public CompletableFuture<BufferedImage> picture() {
        return application.picture();
    }

    @Override
    public CompletableFuture<Void> failure() {
        return application.failure();
    }

    @Override
    public double frameRate() {
        return application.frameRate();
    }

    @Override
    public void close() {
        try {
            application.end();
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }
}
