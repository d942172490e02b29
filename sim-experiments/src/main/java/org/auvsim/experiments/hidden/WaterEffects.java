package org.auvsim.experiments.hidden;

import org.apache.commons.math3.geometry.euclidean.threed.Vector3D;
import org.apache.commons.math3.util.FastMath;

import java.util.List;
import java.util.Map;

/** Currents that the model does not know. */
final class WaterEffects {
    private WaterEffects() {}

    static Family constant(Scene scene, Draws draws) {
        Vector3D direction = draws.flatDirection();
        return Family.of(
                0.2 * scene.speed(),
                s -> {
                    Vector3D u = direction.scalarMultiply(s);
                    return HiddenEffect.of(
                            "current_constant", Map.of("u", Numbers.of(u)), r -> r.in((p, t) -> u));
                });
    }

    static Family oscillating(Scene scene, Draws draws) {
        Vector3D direction = draws.flatDirection();
        double omega = Rhythm.omega(scene, draws);
        double phase = draws.between(-Math.PI, Math.PI);
        return Family.of(
                0.3 * scene.speed(),
                s -> {
                    Vector3D u = direction.scalarMultiply(s);
                    return HiddenEffect.of(
                            "current_oscillating",
                            Map.of(
                                    "u",
                                    Numbers.of(u),
                                    "omega",
                                    Numbers.of(omega),
                                    "phase",
                                    Numbers.of(phase)),
                            r -> r.in((p, t) -> u.scalarMultiply(FastMath.sin(omega * t + phase))));
                });
    }

    static Family shear(Scene scene, Draws draws) {
        double azimuth = draws.between(-Math.PI, Math.PI);
        Vector3D direction = new Vector3D(FastMath.cos(azimuth), FastMath.sin(azimuth), 0);
        return Family.of(
                0.01,
                s -> {
                    Vector3D rate = direction.scalarMultiply(s);
                    return HiddenEffect.of(
                            "current_shear",
                            Map.of("rate", List.of(rate.getX(), rate.getY())),
                            r -> r.in((p, t) -> rate.scalarMultiply(p.getZ())));
                });
    }

    static Family vortex(Scene scene, Draws draws) {
        Vector3D near = draws.oneOf(scene.places());
        double x = near.getX() + 0.3 * scene.range() * draws.normal();
        double y = near.getY() + 0.3 * scene.range() * draws.normal();
        double core = scene.range() * draws.between(0.15, 0.4);
        double sign = draws.sign();
        return Family.of(
                scene.speed() * scene.range(),
                s ->
                        HiddenEffect.of(
                                "current_vortex",
                                Map.of(
                                        "centre",
                                        List.of(x, y),
                                        "gamma",
                                        Numbers.of(sign * s),
                                        "core",
                                        Numbers.of(core)),
                                r ->
                                        r.in(
                                                (p, t) ->
                                                        swirl(
                                                                p.getX() - x,
                                                                p.getY() - y,
                                                                sign * s,
                                                                core))));
    }

    /** Round an axis: gamma r / (2 pi (r^2 + core^2)). */
    private static Vector3D swirl(double x, double y, double gamma, double core) {
        double rate = gamma / (2 * Math.PI * (x * x + y * y + core * core));
        return new Vector3D(-rate * y, rate * x, 0);
    }
}
