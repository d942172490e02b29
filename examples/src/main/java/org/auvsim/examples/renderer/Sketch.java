package org.auvsim.examples.renderer;

import org.auvsim.viz.drawing.Painter;
import org.auvsim.viz.drawing.Renderer;
import org.auvsim.viz.drawing.Screen;
import org.auvsim.viz.drawing.ScreenException;

import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.image.BufferedImage;

/** Pictures with a pencil: outlines, of which none hides another. */
public final class Sketch implements Renderer {
    /** Found by {@link java.util.ServiceLoader}. */
    public Sketch() {}

    @Override
    public String name() {
        return "sketch";
    }

    @Override
    public BufferedImage picture(Painter painter, int width, int height) {
        BufferedImage paper = new BufferedImage(width, height, BufferedImage.TYPE_INT_RGB);
        Graphics2D graphics = paper.createGraphics();
        graphics.setColor(new Color(painter.background()));
        graphics.fillRect(0, 0, width, height);
        painter.paint(new Pencil(graphics, painter.camera(), width, height), System.nanoTime());
        graphics.dispose();
        return paper;
    }

    @Override
    public Screen screen(Painter painter) throws ScreenException {
        throw new ScreenException("A sketch is no window: use --picture FILE.");
    }
}
