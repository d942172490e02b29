package org.auvsim.examples.renderer;

import org.auvsim.core.volume.HeightMap;
import org.auvsim.core.volume.Pose;
import org.auvsim.viz.camera.OrbitCamera;
import org.auvsim.viz.drawing.Brush;

import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Line2D;

/** Draws lines and names where they are, rings for what is round or square, and no sea floor. */
final class Pencil implements Brush {
    private final Graphics2D graphics;
    private final OrbitCamera camera;
    private final int width;
    private final int height;
    private final double[] from = new double[3];
    private final double[] to = new double[3];

    Pencil(Graphics2D graphics, OrbitCamera camera, int width, int height) {
        this.graphics = graphics;
        this.camera = camera;
        this.width = width;
        this.height = height;
    }

    /** Finds a place (m) on the picture; whether the camera sees it. */
    private boolean sees(double x, double y, double z, double[] pixel) {
        camera.project(x, y, z, width, height, pixel);
        return pixel[2] > 0 || !camera.isPerspective();
    }

    @Override
    public void ball(Pose pose, double radius, int colour) {
        if (sees(pose.x, pose.y, pose.z, from)) {
            double pixels = radius * camera.pixelsPerMetre(from[2], height);
            graphics.setColor(new Color(colour, true));
            graphics.draw(
                    new Ellipse2D.Double(
                            from[0] - pixels, from[1] - pixels, 2 * pixels, 2 * pixels));
        }
    }

    @Override
    public void box(Pose pose, double x, double y, double z, int colour) {
        ball(pose, Math.max(x, Math.max(y, z)) / 2, colour);
    }

    @Override
    public void tube(Pose pose, double length, double radius, int colour) {
        stroke(pose, -length / 2, length / 2, colour);
    }

    @Override
    public void cone(Pose pose, double length, double radius, int colour) {
        stroke(pose, 0, length, colour);
    }

    /** Along a pose's x axis, from one place on it to another (m). */
    private void stroke(Pose p, double begin, double end, int colour) {
        double dx = 1 - 2 * (p.qy * p.qy + p.qz * p.qz);
        double dy = 2 * (p.qx * p.qy + p.qw * p.qz);
        double dz = 2 * (p.qx * p.qz - p.qw * p.qy);
        line(
                p.x + begin * dx,
                p.y + begin * dy,
                p.z + begin * dz,
                p.x + end * dx,
                p.y + end * dy,
                p.z + end * dz,
                colour);
    }

    @Override
    public void line(double ax, double ay, double az, double bx, double by, double bz, int colour) {
        if (sees(ax, ay, az, from) && sees(bx, by, bz, to)) {
            graphics.setColor(new Color(colour, true));
            graphics.draw(new Line2D.Double(from[0], from[1], to[0], to[1]));
        }
    }

    @Override
    public void surface(long id, HeightMap map, Pose pose, int colour) {}

    @Override
    public void label(double x, double y, double z, String text, int colour) {
        if (sees(x, y, z, from)) {
            graphics.setColor(new Color(colour, true));
            graphics.drawString(text, (float) from[0], (float) from[1]);
        }
    }

    @Override
    public double letters() {
        return (double) graphics.getFont().getSize() / height;
    }
}
