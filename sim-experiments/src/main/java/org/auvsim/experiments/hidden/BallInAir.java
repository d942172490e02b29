package org.auvsim.experiments.hidden;

import org.apache.commons.math3.geometry.euclidean.threed.Vector3D;
import org.apache.commons.math3.util.FastMath;

import java.util.List;

/** A ball that is dropped or thrown, spinning; with its drag known, or thought to have none. */
final class BallInAir implements Body {
    private static final double MASS = 0.2;
    private static final double RADIUS = 0.1;

    @Override
    public String name() {
        return "ball in air";
    }

    @Override
    public Plant plant(Draws draws) {
        return plant(draws.chance(0.5) ? Drag.even(0, 0, 0) : Drag.even(0, 0.009, 2e-5));
    }

    static Plant plant(Drag drag) {
        double moment = 0.4 * MASS * RADIUS * RADIUS;
        return new Plant(
                new Vector3D(2 * RADIUS, 0, 0),
                MASS,
                new Vector3D(moment, moment, moment),
                Vector3D.ZERO,
                Vector3D.ZERO,
                Plant.GRAVITY,
                0,
                Vector3D.ZERO,
                drag,
                List.of(),
                List.of());
    }

    @Override
    public double timeStep() {
        return 0.01;
    }

    @Override
    public boolean showsOrientation(Draws draws) {
        return draws.chance(0.5);
    }

    @Override
    public Manoeuvre manoeuvre(Draws draws) {
        Instant start =
                new Instant(
                        0,
                        new Vector3D(0, 0, draws.between(1, 4)),
                        Attitude.turned(draws.direction().scalarMultiply(draws.between(0, 3))),
                        draws.chance(0.25) ? draws.normals(0.1) : thrown(draws),
                        draws.box(-8, 8),
                        Vector3D.ZERO);
        return new Manoeuvre(start, draws.between(2, 4), 50, List.of(), List.of());
    }

    private static Vector3D thrown(Draws draws) {
        double speed = draws.between(5, 15);
        double elevation = draws.between(0.3, 1.3);
        double azimuth = draws.between(-Math.PI, Math.PI);
        double along = speed * FastMath.cos(elevation);
        return new Vector3D(
                along * FastMath.cos(azimuth),
                along * FastMath.sin(azimuth),
                speed * FastMath.sin(elevation));
    }
}
