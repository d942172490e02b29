// SPDX-License-Identifier: GPL-2.0-or-later
package org.auvsim.osp.drawing;

import org.auvsim.viz.camera.OrbitCamera;

/**
 * What a camera sees of the world during a frame. Places are counted from what it looks at, and
 * what is outside the picture is cut off, as Open Source Physics paints what is behind, too.
 */
final class View {
    /** The nearest and the farthest that is seen, in parts of the distance to the target. */
    private static final double NEAR = 0.003;

    private static final double FAR = 1e4;

    /** Without perspective the eye stands so many times as far away. */
    private static final double FARTHER = 300;

    /** A little more than the picture is kept, so that cuts are not seen. */
    private static final double MARGIN = 1.02;

    private final double[] origin = new double[3];
    private final double[] forward = new double[3];
    private final Plane[] sides = new Plane[6];
    private boolean perspective;
    private int width;
    private int height;
    private double away;
    private double near;
    private double scale;

    View() {
        for (int i = 0; i < sides.length; i++) {
            sides[i] = new Plane(0, 0, 0, 0);
        }
    }

    /** Sees what a camera does in a picture of so many pixels. */
    void see(OrbitCamera camera, int wide, int high) {
        perspective = camera.isPerspective();
        width = wide;
        height = high;
        for (int axis = 0; axis < 3; axis++) {
            origin[axis] = camera.target(axis);
            forward[axis] = camera.forward(axis);
        }
        double distance = camera.distance();
        away = perspective ? distance : FARTHER * distance;
        near = NEAR * away;
        double slope = Math.tan(OrbitCamera.FIELD_OF_VIEW / 2);
        scale = perspective ? height / 2.0 / slope : height / camera.height();
        double up = MARGIN * slope;
        double right = up * width / height;
        sides[0] = new Plane(forward[0], forward[1], forward[2], near - away);
        sides[1] = new Plane(-forward[0], -forward[1], -forward[2], away - FAR * away);
        sides[2] = side(camera.up(0), camera.up(1), camera.up(2), up, distance);
        sides[3] = side(-camera.up(0), -camera.up(1), -camera.up(2), up, distance);
        sides[4] = side(camera.right(0), camera.right(1), camera.right(2), right, distance);
        sides[5] = side(-camera.right(0), -camera.right(1), -camera.right(2), right, distance);
    }

    private Plane side(double x, double y, double z, double slope, double distance) {
        double lean = perspective ? slope : 0;
        return new Plane(
                x + lean * forward[0],
                y + lean * forward[1],
                z + lean * forward[2],
                -slope * distance);
    }

    /** The world's coordinate {@code axis} (m) of what places are counted from. */
    double origin(int axis) {
        return origin[axis];
    }

    double forward(int axis) {
        return forward[axis];
    }

    boolean isPerspective() {
        return perspective;
    }

    int width() {
        return width;
    }

    int height() {
        return height;
    }

    /** How far the eye is from the target (m). */
    double away() {
        return away;
    }

    /** The least depth that is seen (m). */
    double near() {
        return near;
    }

    /** How deep in the picture a place is (m from the eye). */
    double depth(double x, double y, double z) {
        return away + x * forward[0] + y * forward[1] + z * forward[2];
    }

    /** How many pixels a metre takes at a depth (m). */
    double pixelsPerMetre(double depth) {
        return perspective ? scale / Math.max(depth, near) : scale;
    }

    /** What is seen of a convex polygon, or of a line of two places. */
    double[][] cut(double[][] polygon) {
        double[][] left = polygon;
        for (Plane side : sides) {
            left = side.keep(left);
        }
        return left;
    }

    /** Whether something of a ball may be seen. */
    boolean sees(double[] middle, double radius) {
        for (Plane side : sides) {
            double length =
                    Math.sqrt(
                            side.nx() * side.nx() + side.ny() * side.ny() + side.nz() * side.nz());
            if (side.above(middle) < -radius * length) {
                return false;
            }
        }
        return true;
    }

    /** Whether the eye is on the side of a plane to which its normal points. */
    boolean isBefore(Plane plane) {
        return perspective
                ? -away
                                * (plane.nx() * forward[0]
                                        + plane.ny() * forward[1]
                                        + plane.nz() * forward[2])
                        > plane.d()
                : plane.nx() * forward[0] + plane.ny() * forward[1] + plane.nz() * forward[2] < 0;
    }
}
