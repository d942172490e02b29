package org.auvsim.viz.drawing;

import org.auvsim.core.volume.HeightMap;
import org.auvsim.core.volume.Pose;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/** Writes down what it is asked to paint, a line each. */
final class RecordingBrush implements Brush {
    final List<String> painted = new ArrayList<>();

    @Override
    public void ball(Pose p, double radius, int colour) {
        painted.add(
                String.format(
                        Locale.ROOT,
                        "ball %.3f %.3f %.3f r %.3f %08x",
                        p.x,
                        p.y,
                        p.z,
                        radius,
                        colour));
    }

    @Override
    public void box(Pose p, double x, double y, double z, int colour) {
        painted.add(
                String.format(
                        Locale.ROOT,
                        "box %.3f %.3f %.3f s %.3f %.3f %.3f %08x",
                        p.x,
                        p.y,
                        p.z,
                        x,
                        y,
                        z,
                        colour));
    }

    @Override
    public void tube(Pose p, double length, double radius, int colour) {
        painted.add(
                String.format(
                        Locale.ROOT,
                        "tube %.3f %.3f %.3f l %.3f r %.3f %08x",
                        p.x,
                        p.y,
                        p.z,
                        length,
                        radius,
                        colour));
    }

    @Override
    public void cone(Pose p, double length, double radius, int colour) {
        painted.add(String.format(Locale.ROOT, "cone %.3f %.3f %.3f %08x", p.x, p.y, p.z, colour));
    }

    @Override
    public void line(double ax, double ay, double az, double bx, double by, double bz, int colour) {
        painted.add(
                String.format(
                        Locale.ROOT,
                        "line %.3f %.3f %.3f to %.3f %.3f %.3f %08x",
                        ax,
                        ay,
                        az,
                        bx,
                        by,
                        bz,
                        colour));
    }

    @Override
    public void lineBefore(
            double ax, double ay, double az, double bx, double by, double bz, int colour) {
        line(ax, ay, az, bx, by, bz, colour);
        painted.add("before " + painted.removeLast());
    }

    @Override
    public void surface(long id, HeightMap map, Pose p, int colour) {
        painted.add(
                String.format(
                        Locale.ROOT, "surface %d %.3f %.3f %.3f %08x", id, p.x, p.y, p.z, colour));
    }

    @Override
    public void label(double x, double y, double z, String text, int colour) {
        painted.add("label " + text);
    }

    @Override
    public double letters() {
        return 0.02;
    }
}
