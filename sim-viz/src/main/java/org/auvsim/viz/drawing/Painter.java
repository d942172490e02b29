package org.auvsim.viz.drawing;

import org.auvsim.viz.camera.OrbitCamera;

/** What a renderer asks for each picture. */
public interface Painter {
    /** Paints all there is at an instant of the machine's clock (ns), on the renderer's thread. */
    void paint(Brush brush, long nanos);

    /** From where it is seen. */
    OrbitCamera camera();

    /** The colour behind everything, 0xAARRGGBB. */
    int background();
}
