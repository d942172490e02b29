package org.auvsim.viz.drawing;

import org.auvsim.viz.camera.OrbitCamera;
import org.auvsim.viz.scene.ActorView;
import org.auvsim.viz.scene.Scene;
import org.auvsim.viz.scene.SceneLook;

/** Brings everything that a scene holds into the picture. */
public final class Framing {
    /** What is seen fills so much less of the picture than it could. */
    private static final double MARGIN = 1.15;

    private static final double LEAST = 1;

    private final double[] low = new double[3];
    private final double[] high = new double[3];
    private boolean empty = true;

    private Framing() {}

    /**
     * Lets a camera see all that moves; if nothing does, all that has an end; if there is nothing,
     * the scene's origin.
     */
    public static void fit(Scene scene, OrbitCamera camera) {
        Framing framing = new Framing();
        scene.look(
                System.nanoTime(),
                look -> {
                    framing.measure(look, /* fixed= */ false);
                    if (framing.empty) {
                        framing.measure(look, /* fixed= */ true);
                    }
                });
        framing.aim(camera);
    }

    private void measure(SceneLook look, boolean fixed) {
        for (int i = 0; i < look.count(); i++) {
            double radius = look.actor(i).radius();
            if (radius < Double.POSITIVE_INFINITY && look.actor(i).object().isFixed() == fixed) {
                include(look.actor(i), radius);
            }
        }
    }

    private void include(ActorView actor, double radius) {
        for (int axis = 0; axis < 3; axis++) {
            double at = actor.position(axis);
            low[axis] = empty ? at - radius : Math.min(low[axis], at - radius);
            high[axis] = empty ? at + radius : Math.max(high[axis], at + radius);
        }
        empty = false;
    }

    private void aim(OrbitCamera camera) {
        double square = 0;
        for (int axis = 0; axis < 3; axis++) {
            double half = (high[axis] - low[axis]) / 2;
            square += half * half;
        }
        double radius = Math.max(Math.sqrt(square), LEAST);
        camera.aim(
                (low[0] + high[0]) / 2,
                (low[1] + high[1]) / 2,
                (low[2] + high[2]) / 2,
                MARGIN * radius / Math.sin(OrbitCamera.FIELD_OF_VIEW / 2));
    }
}
