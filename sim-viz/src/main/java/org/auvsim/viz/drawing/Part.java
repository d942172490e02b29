package org.auvsim.viz.drawing;

import org.auvsim.viz.scene.SceneLook;

/** One kind of thing in the picture. */
interface Part {
    /** Paints it; makes no garbage. */
    void paint(SceneLook look, Picture picture);
}
