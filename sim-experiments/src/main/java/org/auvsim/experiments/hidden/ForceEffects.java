package org.auvsim.experiments.hidden;

import org.apache.commons.math3.geometry.euclidean.threed.Vector3D;
import org.apache.commons.math3.util.FastMath;
import org.auvsim.experiments.hidden.Companion.Kick;

import java.util.List;
import java.util.Map;

/** Forces that the model does not know. */
final class ForceEffects {
    /** Speed (m/s) below which dry friction falls to nothing. */
    private static final double SLIP = 0.01;

    private ForceEffects() {}

    /** A force (N) that would bring the body half its range away within a run. */
    private static double unit(Scene scene) {
        return 0.2 * scene.plant().mass() * scene.range() / FastMath.pow(scene.duration(), 2);
    }

    static Family buoyancyWeight(Scene scene, Draws draws) {
        double sign = draws.sign();
        return Family.of(
                unit(scene),
                s ->
                        HiddenEffect.of(
                                "buoyancy_weight",
                                Map.of("force", Numbers.of(sign * s)),
                                r -> r.pushed(at -> Wrench.force(new Vector3D(0, 0, sign * s)))));
    }

    static Family coulombFriction(Scene scene, Draws draws) {
        double weight = scene.plant().mass() * Plant.GRAVITY;
        return Family.of(
                unit(scene) / weight,
                s ->
                        HiddenEffect.of(
                                "coulomb_friction",
                                Map.of("mu", Numbers.of(s)),
                                r ->
                                        r.pushed(
                                                at -> {
                                                    Vector3D v = at.velocity();
                                                    double size = FastMath.max(v.getNorm(), SLIP);
                                                    return Wrench.force(
                                                            v.scalarMultiply(-s * weight / size));
                                                })));
    }

    static Family magnetic(Scene scene, Draws draws) {
        Vector3D source = scene.besidePaths(0.25, draws);
        double sign = draws.sign();
        return Family.of(
                unit(scene) * FastMath.pow(scene.range() / 2, 4),
                s ->
                        HiddenEffect.of(
                                "magnetic",
                                Map.of(
                                        "source",
                                        Numbers.of(source),
                                        "strength",
                                        Numbers.of(sign * s)),
                                r ->
                                        r.pushed(
                                                at -> {
                                                    Vector3D d = source.subtract(at.position());
                                                    double far = d.getNorm();
                                                    return Wrench.force(
                                                            d.scalarMultiply(
                                                                    sign
                                                                            * s
                                                                            / FastMath.pow(
                                                                                    far, 5)));
                                                })));
    }

    static Family magnus(Scene scene, Draws draws) {
        double sign = draws.sign();
        return Family.of(
                unit(scene) / scene.speed(),
                s ->
                        HiddenEffect.of(
                                "magnus",
                                Map.of("s", Numbers.of(sign * s)),
                                r ->
                                        r.pushed(
                                                at ->
                                                        Wrench.force(
                                                                at.turningInWorld()
                                                                        .crossProduct(
                                                                                at.throughWater())
                                                                        .scalarMultiply(
                                                                                sign * s)))));
    }

    static Family tether(Scene scene, Draws draws) {
        Vector3D anchor = scene.besidePaths(0.1, draws);
        double[] distances =
                scene.places().stream().mapToDouble(anchor::distance).sorted().toArray();
        double length = distances[(int) (draws.between(0.1, 0.5) * distances.length)];
        return Family.of(
                unit(scene) / scene.range(),
                s ->
                        HiddenEffect.of(
                                "tether_spring",
                                Map.of(
                                        "anchor",
                                        Numbers.of(anchor),
                                        "length",
                                        Numbers.of(length),
                                        "k",
                                        Numbers.of(s)),
                                r ->
                                        r.pushed(
                                                at -> {
                                                    Vector3D d = anchor.subtract(at.position());
                                                    double far = d.getNorm();
                                                    double pull = s * FastMath.max(0, far - length);
                                                    return Wrench.force(
                                                            d.scalarMultiply(pull / far));
                                                })));
    }

    static Family wave(Scene scene, Draws draws) {
        double omega = Rhythm.omega(scene, draws);
        double phase = draws.between(-Math.PI, Math.PI);
        double azimuth = draws.between(0, Math.PI);
        Vector3D along = new Vector3D(FastMath.cos(azimuth), FastMath.sin(azimuth), 0);
        return Family.of(
                20 * unit(scene),
                s ->
                        HiddenEffect.of(
                                "wave_forcing",
                                Map.of(
                                        "amplitude",
                                        Numbers.of(s),
                                        "direction",
                                        Numbers.of(azimuth),
                                        "omega",
                                        Numbers.of(omega),
                                        "phase",
                                        Numbers.of(phase)),
                                r -> r.pushed(swinging(along.scalarMultiply(s), omega, phase))));
    }

    static Family periodic(Scene scene, Draws draws) {
        double omega = Rhythm.omega(scene, draws);
        double phase = draws.between(-Math.PI, Math.PI);
        // Steep, or it would be a wave.
        Vector3D along =
                new Vector3D(draws.normal(), draws.normal(), draws.sign() * draws.between(1, 2))
                        .normalize();
        return Family.of(
                20 * unit(scene),
                s ->
                        HiddenEffect.of(
                                "periodic_force",
                                Map.of(
                                        "force",
                                        Numbers.of(along.scalarMultiply(s)),
                                        "omega",
                                        Numbers.of(omega),
                                        "phase",
                                        Numbers.of(phase)),
                                r -> r.pushed(swinging(along.scalarMultiply(s), omega, phase))));
    }

    private static Force swinging(Vector3D amplitude, double omega, double phase) {
        return at ->
                Wrench.force(amplitude.scalarMultiply(FastMath.sin(omega * at.time() + phase)));
    }

    static Family step(Scene scene, Draws draws) {
        Vector3D along = draws.direction();
        double from = scene.duration() * draws.between(0.2, 0.6);
        return Family.of(
                2 * unit(scene),
                s -> {
                    Vector3D force = along.scalarMultiply(s);
                    return HiddenEffect.of(
                            "step_force",
                            Map.of("force", Numbers.of(force), "from", Numbers.of(from)),
                            r ->
                                    r.edge(from)
                                            .pushed(
                                                    at ->
                                                            at.time() > from
                                                                    ? Wrench.force(force)
                                                                    : Wrench.NONE));
                });
    }

    static Family impulse(Scene scene, Draws draws) {
        Vector3D along = draws.direction();
        double at = scene.duration() * draws.between(0.2, 0.7);
        return Family.of(
                unit(scene) * scene.duration(),
                s -> {
                    Vector3D impulse = along.scalarMultiply(s);
                    return HiddenEffect.of(
                            "impulse",
                            Map.of("impulse", Numbers.of(impulse), "at", Numbers.of(at)),
                            r -> r.accompanied(random -> once(new Kick(at, impulse))));
                });
    }

    private static Companion once(Kick kick) {
        return new Companion() {
            @Override
            public List<Kick> kicks() {
                return List.of(kick);
            }
        };
    }
}
