// SPDX-License-Identifier: GPL-2.0-or-later
package org.auvsim.osp.drawing;

import org.opensourcephysics.display3d.core.Camera;
import org.opensourcephysics.display3d.simple3d.DrawingPanel3D;

/**
 * Lets the camera of Open Source Physics see what ours does. That one stretches a length to the
 * shorter side of the picture: half of it in perspective, 0.65 of it without.
 */
final class OspCamera {
    private static final double ORTHOGRAPHIC = 1.3;

    private final DrawingPanel3D panel;
    private double size = Double.NaN;

    OspCamera(DrawingPanel3D panel) {
        this.panel = panel;
    }

    void apply(View view) {
        Camera camera = panel.getCamera();
        int mode = view.isPerspective() ? Camera.MODE_PERSPECTIVE : Camera.MODE_NO_PERSPECTIVE;
        if (camera.getProjectionMode() != mode) {
            camera.setProjectionMode(mode);
        }
        double shorter = Math.min(view.width(), view.height());
        // In perspective any size will do; it is also a hundred times the least depth.
        stretch(
                view.isPerspective()
                        ? 10 * view.near()
                        : ORTHOGRAPHIC * shorter / 2 / view.pixelsPerMetre(view.away()));
        camera.setXYZ(
                -view.away() * view.forward(0),
                -view.away() * view.forward(1),
                -view.away() * view.forward(2));
        camera.setFocusXYZ(0, 0, 0);
        camera.setDistanceToScreen(
                size * view.away() * view.pixelsPerMetre(view.away()) / (shorter / 2));
    }

    private void stretch(double to) {
        if (to != size) {
            size = to;
            panel.setPreferredMinMax(0, to, 0, to, 0, to);
        }
    }
}
