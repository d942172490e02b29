package org.auvsim.viz.drawing;

import org.auvsim.viz.camera.OrbitCamera;

/**
 * What all parts of one picture share.
 *
 * @param brush paints
 * @param options say what is shown
 * @param palette of the picture
 * @param camera from which it is seen
 */
record Picture(Brush brush, ViewOptions options, Palette palette, OrbitCamera camera) {
    /** A length (m) that is this part of the picture's height, seen at the target. */
    double share(double part) {
        return camera.height() * part;
    }
}
