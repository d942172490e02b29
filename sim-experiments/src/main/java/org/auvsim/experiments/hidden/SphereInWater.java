package org.auvsim.experiments.hidden;

import org.apache.commons.math3.geometry.euclidean.threed.Vector3D;

import java.util.List;

/** A ball that hardly sinks and is pushed about. */
final class SphereInWater implements Body {
    private static final double RADIUS = 0.15;
    private static final double MASS = 14.6;
    private static final double DISPLACED = 14.5;

    @Override
    public String name() {
        return "sphere in water";
    }

    @Override
    public Plant plant(Draws draws) {
        double moment = 0.4 * MASS * RADIUS * RADIUS;
        double added = DISPLACED / 2;
        return new Plant(
                new Vector3D(2 * RADIUS, 0, 0),
                MASS,
                new Vector3D(moment, moment, moment),
                new Vector3D(added, added, added),
                Vector3D.ZERO,
                Plant.GRAVITY,
                DISPLACED,
                Vector3D.ZERO,
                Drag.even(1, 14, 0.1),
                List.of(),
                List.of());
    }

    @Override
    public double timeStep() {
        return 0.02;
    }

    @Override
    public boolean showsOrientation(Draws draws) {
        return draws.chance(0.5);
    }

    @Override
    public Manoeuvre manoeuvre(Draws draws) {
        double duration = draws.between(20, 30);
        int rate = draws.oneOf(List.of(10, 20, 25));
        return new Manoeuvre(
                Pushing.start(draws),
                (double) Math.round(duration),
                rate,
                List.of(),
                new Pushing(4, 20, 0.02).draw((double) Math.round(duration), draws));
    }
}
