package org.auvsim.viz.jme;

import com.jme3.math.Vector3f;
import com.jme3.renderer.Camera;

import org.auvsim.viz.camera.OrbitCamera;

/** Lets jMonkeyEngine's camera see what ours does, counted from a picture's own origin. */
final class JmeCamera {
    /** The nearest and the farthest that is seen, in parts of the distance to the target. */
    private static final double NEAR = 0.01;

    private static final double FAR = 300;

    private final Vector3f place = new Vector3f();
    private final Vector3f left = new Vector3f();
    private final Vector3f up = new Vector3f();
    private final Vector3f ahead = new Vector3f();

    /** The brush's picture is seen from our camera by theirs. */
    void apply(OrbitCamera from, JmeBrush brush, Camera to) {
        set(ahead, from.forward(0), from.forward(1), from.forward(2), 1);
        set(up, from.up(0), from.up(1), from.up(2), 1);
        set(left, from.right(0), from.right(1), from.right(2), -1);
        double distance = from.distance();
        set(
                place,
                from.position(0) - brush.origin(0),
                from.position(1) - brush.origin(1),
                from.position(2) - brush.origin(2),
                1);
        double near = NEAR * distance;
        double half = from.height() / 2;
        if (from.isPerspective()) {
            half *= near / distance;
        }
        double wide = half * to.getWidth() / Math.max(1, to.getHeight());
        to.setParallelProjection(!from.isPerspective());
        to.setFrustum(
                (float) (from.isPerspective() ? near : -FAR * distance),
                (float) (FAR * distance),
                (float) -wide,
                (float) wide,
                (float) half,
                (float) -half);
        to.setFrame(place, left, up, ahead);
    }

    private static void set(Vector3f to, double x, double y, double z, double factor) {
        to.set((float) (factor * x), (float) (factor * y), (float) (factor * z));
    }
}
