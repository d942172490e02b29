package org.auvsim.experiments.hidden;

import org.apache.commons.math3.geometry.euclidean.threed.Vector3D;

import java.util.List;

/** A box in water that is pushed at its sides. */
final class PushedBox implements Body {
    @Override
    public String name() {
        return "pushed box";
    }

    @Override
    public Plant plant(Draws draws) {
        return new Plant(
                new Vector3D(0.6, 0.4, 0.3),
                74,
                new Vector3D(1.54, 2.78, 3.21),
                new Vector3D(20, 35, 50),
                new Vector3D(0.5, 0.8, 0.6),
                Plant.GRAVITY,
                73.8,
                new Vector3D(0, 0, 0.01),
                Drag.byAxes(
                        new Vector3D(8, 12, 15),
                        new Vector3D(60, 90, 130),
                        new Vector3D(1, 1.2, 1),
                        new Vector3D(2, 3, 2.5)),
                List.of(),
                List.of());
    }

    @Override
    public double timeStep() {
        return 0.02;
    }

    @Override
    public boolean showsOrientation(Draws draws) {
        return true;
    }

    @Override
    public Manoeuvre manoeuvre(Draws draws) {
        double duration = Math.round(draws.between(20, 35));
        int rate = draws.oneOf(List.of(10, 20, 25));
        return new Manoeuvre(
                Pushing.start(draws),
                duration,
                rate,
                List.of(),
                new Pushing(20, 80, 0.1).draw(duration, draws));
    }
}
