// SPDX-License-Identifier: GPL-2.0-or-later
package org.auvsim.osp.drawing;

import org.auvsim.viz.drawing.Painter;
import org.auvsim.viz.drawing.Renderer;
import org.auvsim.viz.drawing.Screen;

import java.awt.image.BufferedImage;

/**
 * Paints with simple3d of Open Source Physics: by processor alone, far before near. A picture needs
 * no display.
 */
public final class OspRenderer implements Renderer {
    /** A picture is painted so many times as wide and high, and made smaller: smooth edges. */
    private static final int FINER = 2;

    /** Found by {@link java.util.ServiceLoader}. */
    public OspRenderer() {}

    @Override
    public String name() {
        return "osp";
    }

    @Override
    public Screen screen(Painter painter) {
        return new OspScreen(painter);
    }

    @Override
    public BufferedImage picture(Painter painter, int width, int height) {
        BufferedImage large =
                new BufferedImage(FINER * width, FINER * height, BufferedImage.TYPE_INT_RGB);
        new Studio(painter, FINER).paint(large);
        return Shrinking.by(FINER, large);
    }
}
