// SPDX-License-Identifier: GPL-2.0-or-later
package org.auvsim.osp.drawing;

import org.jspecify.annotations.Nullable;

import java.util.ArrayList;
import java.util.List;
import java.util.function.ObjIntConsumer;

/**
 * A part of space, divided by large faces, so that what is behind such a face is painted before it
 * and what is before it afterwards; a sort by the middles of faces alone gets large ones wrong.
 */
final class Region {
    private @Nullable Wall wall;
    private int order;

    /** What divides a region in two, and the faces that lie in it. */
    private record Wall(Plane plane, Region below, Region above, List<Face> faces) {}

    /** How a face is numbered: from the farthest region to the nearest. */
    interface Numbered extends ObjIntConsumer<Face> {}

    /** Divides it by a large face; what is nearer to a plane than {@code least} (m) is in it. */
    void divide(Face face, double least) {
        if (wall == null) {
            List<Face> faces = new ArrayList<>();
            faces.add(face);
            wall = new Wall(Plane.of(face.corners()), new Region(), new Region(), faces);
            return;
        }
        int side = side(wall.plane(), face.corners(), least);
        if (side == IN) {
            wall.faces().add(face);
        }
        if ((side & ABOVE) != 0) {
            wall.above().divide(part(wall.plane(), face, side), least);
        }
        if ((side & BELOW) != 0) {
            wall.below().divide(part(wall.plane().opposite(), face, side), least);
        }
    }

    private static final int IN = 0;
    private static final int ABOVE = 1;
    private static final int BELOW = 2;

    private static int side(Plane plane, double[][] corners, double least) {
        int side = IN;
        for (double[] corner : corners) {
            double above = plane.above(corner);
            side |= above > least ? ABOVE : above < -least ? BELOW : IN;
        }
        return side;
    }

    private static Face part(Plane plane, Face face, int side) {
        return side == (ABOVE | BELOW) ? face.with(plane.keep(face.corners())) : face;
    }

    /** Numbers what it is divided into from far to near; returns the number after the last. */
    int number(View view, int first) {
        if (wall == null) {
            order = first;
            return first + 1;
        }
        boolean above = view.isBefore(wall.plane());
        order = (above ? wall.below() : wall.above()).number(view, first);
        return (above ? wall.above() : wall.below()).number(view, order + 1);
    }

    /** Gives the faces that divide it, with their numbers. */
    void give(Numbered to) {
        if (wall != null) {
            wall.below().give(to);
            wall.faces().forEach(face -> to.accept(face, order));
            wall.above().give(to);
        }
    }

    /** Gives the parts of a face, with their numbers. */
    void sort(Face face, View view, double least, Numbered to) {
        if (wall == null) {
            to.accept(face, order);
            return;
        }
        int side = side(wall.plane(), face.corners(), least);
        if (side == IN) {
            side = view.isBefore(wall.plane()) ? ABOVE : BELOW;
        }
        if ((side & ABOVE) != 0) {
            wall.above().sort(part(wall.plane(), face, side), view, least, to);
        }
        if ((side & BELOW) != 0) {
            wall.below().sort(part(wall.plane().opposite(), face, side), view, least, to);
        }
    }
}
