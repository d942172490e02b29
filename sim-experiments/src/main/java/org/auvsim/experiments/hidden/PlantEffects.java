package org.auvsim.experiments.hidden;

import static org.auvsim.experiments.hidden.Equations.times;

import org.apache.commons.math3.geometry.euclidean.threed.Vector3D;

import java.util.Map;

/** What the model has wrong of the body itself. */
final class PlantEffects {
    private PlantEffects() {}

    static Family linearDrag(Scene scene, Draws draws) {
        return Family.of(
                scene.plant().mass() / scene.duration(),
                s ->
                        HiddenEffect.of(
                                "linear_drag",
                                Map.of("c", Numbers.of(s)),
                                r -> r.with(p -> p.withDrag(d -> d.withEven(s, 0, 0)))));
    }

    static Family quadraticDrag(Scene scene, Draws draws) {
        return Family.of(
                scene.plant().mass() / scene.range(),
                s ->
                        HiddenEffect.of(
                                "quadratic_drag",
                                Map.of("k", Numbers.of(s)),
                                r -> r.with(p -> p.withDrag(d -> d.withEven(0, s, 0)))));
    }

    static Family anisotropicDrag(Scene scene, Draws draws) {
        Vector3D share = draws.box(0.1, 2);
        return Family.of(
                scene.plant().mass() / scene.range(),
                s -> {
                    Vector3D k = share.scalarMultiply(s);
                    return HiddenEffect.of(
                            "anisotropic_drag",
                            Map.of("k", Numbers.of(k)),
                            r -> r.with(p -> p.withDrag(d -> d.withQuadratic(k))));
                });
    }

    static Family rotationalDrag(Scene scene, Draws draws) {
        return Family.of(
                scene.plant().inertia().getZ() / scene.duration(),
                s ->
                        HiddenEffect.of(
                                "rotational_drag",
                                Map.of("c", Numbers.of(s)),
                                r -> r.with(p -> p.withDrag(d -> d.withEven(0, 0, s)))));
    }

    static Family addedMass(Scene scene, Draws draws) {
        Vector3D share = draws.box(0.1, 1);
        return new Family(
                0.3 * scene.plant().mass(),
                0,
                3 * scene.plant().mass(),
                s -> {
                    Vector3D ma = share.scalarMultiply(s);
                    return HiddenEffect.of(
                            "added_mass",
                            Map.of("ma", Numbers.of(ma)),
                            r -> r.with(p -> p.withAddedMass(p.addedMass().add(ma))));
                });
    }

    static Family cobOffset(Scene scene, Draws draws) {
        Vector3D along = draws.direction();
        return Family.upTo(
                0.1,
                s -> {
                    Vector3D offset = along.scalarMultiply(s);
                    return HiddenEffect.of(
                            "cob_offset",
                            Map.of("offset", Numbers.of(offset)),
                            r -> r.with(p -> p.withBuoyancyCentre(p.buoyancyCentre().add(offset))));
                });
    }

    /** What floats and is a little heavier has another weight: its inertia could not be seen. */
    static Family mass(Scene scene, Draws draws) {
        double sign = draws.sign();
        return Family.between(
                0.05,
                0.6,
                s ->
                        HiddenEffect.of(
                                "mass_error",
                                Map.of("factor", Numbers.of(1 + sign * s)),
                                r -> r.with(p -> p.withMass(p.mass() * (1 + sign * s)))));
    }

    static Family inertia(Scene scene, Draws draws) {
        Vector3D share = draws.box(-1, 1);
        return Family.upTo(
                0.7,
                s -> {
                    Vector3D factor = new Vector3D(1, 1, 1).add(s, share);
                    return HiddenEffect.of(
                            "inertia_error",
                            Map.of("factor", Numbers.of(factor)),
                            r -> r.with(p -> p.withInertia(times(p.inertia(), factor))));
                });
    }
}
