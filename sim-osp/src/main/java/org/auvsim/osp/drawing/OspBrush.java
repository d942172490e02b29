// SPDX-License-Identifier: GPL-2.0-or-later
package org.auvsim.osp.drawing;

import org.auvsim.core.volume.HeightMap;
import org.auvsim.core.volume.Pose;
import org.auvsim.viz.drawing.Brush;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;

/** Collects a frame's faces, lines and words, and brings them on the stage from far to near. */
final class OspBrush implements Brush {
    /** Rings of balls, sides of tubes and cones: the finer, the more pixels their radius takes. */
    private static final Shape[] BALLS = {
        Shape.ball(2), Shape.ball(4), Shape.ball(7), Shape.ball(12)
    };

    private static final Shape[] TUBES = {
        Shape.tube(4, 1), Shape.tube(6, 2), Shape.tube(12, 4), Shape.tube(24, 6)
    };
    private static final Shape[] CONES = {
        Shape.cone(4), Shape.cone(6), Shape.cone(12), Shape.cone(24)
    };

    /** A shape of so many pixels' radius is painted coarser than those that follow. */
    private static final double[] PIXELS = {3, 12, 50};

    private static final Shape CUBE = Shape.cube();
    private static final Shape SQUARE = Shape.square();

    /**
     * A face of this share of the picture's height divides what is before it from what is behind.
     */
    private static final double LARGE = 0.3;

    /** Lines are cut into parts of this share of the distance, to be sorted by their middles. */
    private static final double LINE = 0.1;

    /** Lines of more parts than this give way to what is on them, as the grid does to axes. */
    private static final int SHORT = 4;

    private static final double FARTHER = 1 + LINE;

    /** What is as near to a large face as this share of the distance is in it. */
    private static final double IN_FACE = 1e-5;

    private final List<Face> faces = new ArrayList<>();
    private final List<Face> large = new ArrayList<>();
    private final Turn turn = new Turn();
    private final SeaFloors seaFloors = new SeaFloors();
    private final View view;
    private final Stage stage;

    OspBrush(View view, Stage stage) {
        this.view = view;
        this.stage = stage;
    }

    void begin() {
        faces.clear();
        large.clear();
        stage.begin();
    }

    /** Brings all on the stage. */
    void end() {
        double least = IN_FACE * view.near();
        Region space = new Region();
        large.sort(Comparator.comparingDouble(Face::size).reversed());
        for (Face face : large) {
            if (space.number(view, 0) < Stage.MOST / 2) {
                space.divide(face, least);
            } else {
                faces.add(face);
            }
        }
        space.number(view, 0);
        space.give(stage::show);
        for (Face face : faces) {
            space.sort(face, view, least, stage::show);
        }
        stage.end();
    }

    @Override
    public void ball(Pose pose, double radius, int colour) {
        turn.set(pose, view);
        if (view.sees(turn.middle(), radius)) {
            solid(BALLS[detail(radius)], radius, radius, radius, colour);
        }
    }

    /** How fine something of this radius (m) has to be. */
    private int detail(double radius) {
        double[] at = turn.middle();
        double pixels = radius * view.pixelsPerMetre(view.depth(at[0], at[1], at[2]));
        int detail = 0;
        while (detail < PIXELS.length && pixels > PIXELS[detail]) {
            detail++;
        }
        return detail;
    }

    @Override
    public void box(Pose pose, double x, double y, double z, int colour) {
        turn.set(pose, view);
        if (z == 0) {
            face(SQUARE.faces()[0], x, y, z, false, colour);
        } else {
            solid(CUBE, x, y, z, colour);
        }
    }

    @Override
    public void tube(Pose pose, double length, double radius, int colour) {
        turn.set(pose, view);
        if (view.sees(turn.middle(), length + radius)) {
            solid(TUBES[detail(radius)], length, radius, radius, colour);
        }
    }

    @Override
    public void cone(Pose pose, double length, double radius, int colour) {
        turn.set(pose, view);
        if (view.sees(turn.middle(), length + radius)) {
            solid(CONES[detail(radius)], length, radius, radius, colour);
        }
    }

    private void solid(Shape shape, double x, double y, double z, int colour) {
        for (double[][] face : shape.faces()) {
            face(face, x, y, z, true, colour);
        }
    }

    private void face(double[][] of, double x, double y, double z, boolean oneSided, int colour) {
        double[][] corners = new double[of.length][];
        for (int i = 0; i < of.length; i++) {
            corners[i] = turn.corner(of[i], x, y, z);
        }
        Plane plane = Plane.of(corners);
        if (oneSided && !view.isBefore(plane)) {
            return;
        }
        double[][] seen = view.cut(corners);
        if (seen.length > 2) {
            Face face = new Face(seen, Light.on(colour, plane, view));
            (isLarge(face) ? large : faces).add(face);
        }
    }

    private boolean isLarge(Face face) {
        double[] a = face.corners()[0];
        double[] b = face.corners()[face.corners().length / 2];
        double length = Math.hypot(Math.hypot(a[0] - b[0], a[1] - b[1]), a[2] - b[2]);
        double depth = view.depth((a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2);
        return length * view.pixelsPerMetre(depth) > LARGE * view.height();
    }

    @Override
    public void line(double ax, double ay, double az, double bx, double by, double bz, int colour) {
        double[][] seen = view.cut(new double[][] {here(ax, ay, az), here(bx, by, bz)});
        if (seen.length == 2) {
            parts(seen[0], seen[1], colour);
        }
    }

    private double[] here(double x, double y, double z) {
        return new double[] {x - view.origin(0), y - view.origin(1), z - view.origin(2)};
    }

    private void parts(double[] a, double[] b, int colour) {
        double length = Math.hypot(Math.hypot(b[0] - a[0], b[1] - a[1]), b[2] - a[2]);
        double depth = view.depth((a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2);
        double share = length * view.pixelsPerMetre(depth) / view.height();
        int count = Math.clamp((long) Math.ceil(share / LINE), 1, 40);
        double[] from = a;
        for (int i = 1; i <= count; i++) {
            double part = (double) i / count;
            double[] to = {
                a[0] + part * (b[0] - a[0]),
                a[1] + part * (b[1] - a[1]),
                a[2] + part * (b[2] - a[2])
            };
            faces.add(new Face(new double[][] {from, to}, colour, count > SHORT ? FARTHER : 1));
            from = to;
        }
    }

    @Override
    public void surface(long id, HeightMap map, Pose pose, int colour) {
        turn.set(pose, view);
        for (double[][] face : seaFloors.shape(id, map).faces()) {
            face(face, 1, 1, 1, false, colour);
        }
    }

    @Override
    public void label(double x, double y, double z, String text, int colour) {
        double[] at = here(x, y, z);
        if (view.sees(at, 0)) {
            stage.words(at, text, colour);
        }
    }

    @Override
    public double letters() {
        return (double) stage.letters() / Math.max(1, view.height());
    }
}
