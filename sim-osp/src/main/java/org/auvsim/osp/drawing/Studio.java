// SPDX-License-Identifier: GPL-2.0-or-later
package org.auvsim.osp.drawing;

import org.auvsim.viz.drawing.Painter;
import org.opensourcephysics.display3d.core.VisualizationHints;
import org.opensourcephysics.display3d.simple3d.DrawingPanel3D;

import java.awt.Color;
import java.awt.image.BufferedImage;

/** A panel of Open Source Physics that is never shown itself: it paints into pictures. */
final class Studio {
    private final DrawingPanel3D panel = new DrawingPanel3D();
    private final OspCamera eye = new OspCamera(panel);
    private final View view = new View();
    private final OspBrush brush;
    private final Painter painter;

    /**
     * @param scale how many pixels lines are wide; letters grow with it
     */
    Studio(Painter painter, int scale) {
        this.painter = painter;
        panel.setIgnoreRepaint(true); // or a timer of its own paints it, too
        VisualizationHints hints = panel.getVisualizationHints();
        hints.setDecorationType(VisualizationHints.DECORATION_NONE);
        hints.setCursorType(VisualizationHints.CURSOR_NONE);
        hints.setUseColorDepth(false);
        hints.setRemoveHiddenLines(true);
        brush = new OspBrush(view, new Stage(panel, scale));
    }

    /** Paints how things stand now. */
    void paint(BufferedImage to) {
        panel.setBackground(new Color(painter.background()));
        view.see(painter.camera(), to.getWidth(), to.getHeight());
        brush.begin();
        painter.paint(brush, System.nanoTime());
        brush.end();
        eye.apply(view);
        panel.render(to);
    }
}
