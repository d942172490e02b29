package org.auvsim.viz.drawing;

import org.auvsim.core.volume.HeightMap;
import org.auvsim.core.volume.Pose;

/**
 * What a renderer paints with: shapes for this frame alone, in metres and world axes, z up. Colours
 * are 0xAARRGGBB; what is not opaque lets things behind it show. A pose is read at once and may be
 * reused; a call makes no garbage.
 */
public interface Brush {
    /** A ball about a pose's origin. */
    void ball(Pose pose, double radius, int colour);

    /** A cuboid about a pose's origin, its edges along the pose's axes. */
    void box(Pose pose, double x, double y, double z, int colour);

    /** The side of a cylinder about the pose's x axis, its middle at the origin. */
    void tube(Pose pose, double length, double radius, int colour);

    /** A cone about the pose's x axis from its base at the origin to its tip. */
    void cone(Pose pose, double length, double radius, int colour);

    /** A line of one pixel. */
    void line(double ax, double ay, double az, double bx, double by, double bz, int colour);

    /** The same before everything that would hide it, where the renderer can paint so. */
    default void lineBefore(
            double ax, double ay, double az, double bx, double by, double bz, int colour) {
        line(ax, ay, az, bx, by, bz, colour);
    }

    /** The sea floor of an object, whose map seldom changes. */
    void surface(long id, HeightMap map, Pose pose, int colour);

    /** Words beside a place, as large on the screen wherever that is. */
    void label(double x, double y, double z, String text, int colour);

    /** How high the letters of labels are, as a part of the picture's height. */
    double letters();
}
