// SPDX-License-Identifier: GPL-2.0-or-later
package org.auvsim.osp.drawing;

import org.opensourcephysics.display3d.simple3d.AbstractTile;

import java.util.ArrayList;
import java.util.List;

/** An element of Open Source Physics: polygons of one colour, each painted at its own depth. */
final class Tiles extends AbstractTile {
    private final List<double[][]> polygons = new ArrayList<>();

    Tiles() {
        getStyle().setDrawingLines(false);
    }

    void clear() {
        polygons.clear();
    }

    void add(double[][] polygon) {
        polygons.add(polygon);
        setX(0); // says that it has changed
    }

    @Override
    protected synchronized void computeCorners() {
        setCorners(polygons.toArray(double[][][]::new));
    }
}
