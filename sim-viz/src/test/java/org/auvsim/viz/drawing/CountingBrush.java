package org.auvsim.viz.drawing;

import org.auvsim.core.volume.HeightMap;
import org.auvsim.core.volume.Pose;

/** Counts what it is asked to paint, and keeps nothing of it. */
final class CountingBrush implements Brush {
    long painted;

    @Override
    public void ball(Pose pose, double radius, int colour) {
        painted++;
    }

    @Override
    public void box(Pose pose, double x, double y, double z, int colour) {
        painted++;
    }

    @Override
    public void tube(Pose pose, double length, double radius, int colour) {
        painted++;
    }

    @Override
    public void cone(Pose pose, double length, double radius, int colour) {
        painted++;
    }

    @Override
    public void line(double ax, double ay, double az, double bx, double by, double bz, int colour) {
        painted++;
    }

    @Override
    public void surface(long id, HeightMap map, Pose pose, int colour) {
        painted++;
    }

    @Override
    public void label(double x, double y, double z, String text, int colour) {
        painted++;
    }

    @Override
    public double letters() {
        return 0.02;
    }
}
