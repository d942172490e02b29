package org.auvsim.viz.camera;

import org.auvsim.core.math.Vec3;

/**
 * A camera that looks at a point and goes around it; z is up. Windows move it, renderers ask it,
 * each from a thread of its own.
 */
public final class OrbitCamera {
    /** The picture's height is seen under this angle (rad) in perspective. */
    public static final double FIELD_OF_VIEW = Math.toRadians(45);

    /** The camera comes as near to straight up and down as this (rad), so that it knows its up. */
    private static final double STEEPEST = Math.toRadians(89.9);

    private static final double NEAREST = 1e-3;
    private static final double FARTHEST = 1e6;

    private final double[] target = new double[3];
    private double azimuth = Math.toRadians(-125);
    private double elevation = Math.toRadians(25);
    private double distance = 20;
    private boolean perspective = true;

    /** Looks at a point (m, world) from a distance (m). */
    public synchronized void aim(double x, double y, double z, double from) {
        lookAt(x, y, z);
        distance = Math.clamp(from, NEAREST, FARTHEST);
    }

    /** Looks at another point (m, world), from the same side and as far away. */
    public synchronized void lookAt(double x, double y, double z) {
        target[0] = x;
        target[1] = y;
        target[2] = z;
    }

    /**
     * Looks from a side.
     *
     * @param fromAzimuth where the camera stands as seen from the target, from x to y (rad)
     * @param fromElevation how high it stands, seen from there (rad)
     */
    public synchronized void look(double fromAzimuth, double fromElevation) {
        azimuth = fromAzimuth;
        elevation = Math.clamp(fromElevation, -STEEPEST, STEEPEST);
    }

    /** Goes around the target by angles (rad): to the right and up. */
    public synchronized void orbit(double right, double up) {
        look(azimuth + right, elevation + up);
    }

    /** Goes nearer (below 1) or away (above 1) by a factor. */
    public synchronized void zoom(double factor) {
        distance = Math.clamp(distance * factor, NEAREST, FARTHEST);
    }

    /** Moves the target in the picture's plane, by parts of the picture's height. */
    public synchronized void pan(double right, double up) {
        double height = height();
        for (int axis = 0; axis < 3; axis++) {
            target[axis] += height * (right * right(axis) + up * up(axis));
        }
    }

    /** Sees in perspective, or all things as large as at the target. */
    public synchronized void perspective(boolean on) {
        perspective = on;
    }

    /** Whether it sees in perspective. */
    public synchronized boolean isPerspective() {
        return perspective;
    }

    /** What is looked at (m, world). */
    public synchronized Vec3 target() {
        return new Vec3(target[0], target[1], target[2]);
    }

    /** How far away it is from the target (m). */
    public synchronized double distance() {
        return distance;
    }

    /** How many metres at the target fill the picture's height. */
    public synchronized double height() {
        return 2 * distance * Math.tan(FIELD_OF_VIEW / 2);
    }

    /** Coordinate {@code axis} of the target (m, world). */
    public synchronized double target(int axis) {
        return target[axis];
    }

    /** Coordinate {@code axis} of where the camera stands (m, world). */
    public synchronized double position(int axis) {
        return target[axis] - distance * forward(axis);
    }

    /** Component {@code axis} of the unit vector from the camera to the target. */
    public synchronized double forward(int axis) {
        return switch (axis) {
            case 0 -> -Math.cos(elevation) * Math.cos(azimuth);
            case 1 -> -Math.cos(elevation) * Math.sin(azimuth);
            default -> -Math.sin(elevation);
        };
    }

    /** Component {@code axis} of the unit vector to the picture's right. */
    public synchronized double right(int axis) {
        return switch (axis) {
            case 0 -> -Math.sin(azimuth);
            case 1 -> Math.cos(azimuth);
            default -> 0;
        };
    }

    /** Component {@code axis} of the unit vector to the picture's top. */
    public synchronized double up(int axis) {
        return switch (axis) {
            case 0 -> -Math.sin(elevation) * Math.cos(azimuth);
            case 1 -> -Math.sin(elevation) * Math.sin(azimuth);
            default -> Math.cos(elevation);
        };
    }

    /**
     * Where a point (m, world) is in a picture.
     *
     * @param to gets the pixel from the left, that from the top, and the depth: the distance (m) in
     *     front of the camera, negative behind it
     */
    public synchronized void project(
            double x, double y, double z, int width, int height, double[] to) {
        double dx = x - target[0];
        double dy = y - target[1];
        double dz = z - target[2];
        double depth = distance + dx * forward(0) + dy * forward(1) + dz * forward(2);
        double right = dx * right(0) + dy * right(1) + dz * right(2);
        double up = dx * up(0) + dy * up(1) + dz * up(2);
        double pixels = height / (height() * (perspective ? depth / distance : 1));
        to[0] = width / 2.0 + right * pixels;
        to[1] = height / 2.0 - up * pixels;
        to[2] = depth;
    }

    /** How many pixels a metre takes at a depth (m) in a picture of this height. */
    public synchronized double pixelsPerMetre(double depth, int height) {
        return height / (height() * (perspective ? Math.max(depth, NEAREST) / distance : 1));
    }
}
