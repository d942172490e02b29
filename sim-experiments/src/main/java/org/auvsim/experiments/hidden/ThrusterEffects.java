package org.auvsim.experiments.hidden;

import org.apache.commons.math3.geometry.euclidean.threed.Vector3D;

import java.util.Map;
import java.util.function.UnaryOperator;

/** What the model has wrong of thrusters. */
final class ThrusterEffects {
    private ThrusterEffects() {}

    private static UnaryOperator<Reality> one(String name, UnaryOperator<Thruster> change) {
        return r -> r.with(p -> p.withThrusters(t -> t.name().equals(name) ? change.apply(t) : t));
    }

    private static UnaryOperator<Reality> all(UnaryOperator<Thruster> change) {
        return r -> r.with(p -> p.withThrusters(change));
    }

    static Family gain(Scene scene, Draws draws) {
        String name = draws.oneOf(scene.plant().thrusters()).name();
        double sign = draws.chance(0.8) ? -1 : 1;
        return Family.upTo(
                0.9,
                s ->
                        HiddenEffect.of(
                                        "thruster_gain",
                                        Map.of("factor", Numbers.of(1 + sign * s)),
                                        one(name, t -> t.withGain(1 + sign * s)))
                                .about(name));
    }

    static Family deadZone(Scene scene, Draws draws) {
        return Family.upTo(
                0.3,
                s ->
                        HiddenEffect.of(
                                "thruster_deadzone",
                                Map.of("width", Numbers.of(s)),
                                all(t -> t.withDeadZone(s))));
    }

    static Family lag(Scene scene, Draws draws) {
        return Family.upTo(
                2,
                s ->
                        HiddenEffect.of(
                                "thruster_lag",
                                Map.of("tau", Numbers.of(s)),
                                all(t -> t.withLag(s))));
    }

    static Family misalignment(Scene scene, Draws draws) {
        Thruster thruster = draws.oneOf(scene.plant().thrusters());
        double sign = draws.sign();
        return Family.upTo(
                0.7,
                s ->
                        HiddenEffect.of(
                                        "thruster_misalignment",
                                        Map.of("angle", Numbers.of(sign * s)),
                                        one(
                                                thruster.name(),
                                                t -> t.pointing(turned(t.direction(), sign * s))))
                                .about(thruster.name()));
    }

    /** About the body's upright axis, an upright one about the axis ahead. */
    private static Vector3D turned(Vector3D direction, double angle) {
        boolean upright = Math.abs(direction.getZ()) > 0.9;
        Vector3D axis = upright ? Vector3D.PLUS_I : Vector3D.PLUS_K;
        return Attitude.turned(axis.scalarMultiply(angle)).toWorld(direction);
    }

    /** Its strength is how much of the run it is lost. */
    static Family loss(Scene scene, Draws draws) {
        String name = draws.oneOf(scene.plant().thrusters()).name();
        return Family.upTo(
                0.8,
                s -> {
                    double from = (1 - s) * scene.duration();
                    return HiddenEffect.of(
                                    "thruster_loss",
                                    Map.of("from", Numbers.of(from)),
                                    r -> one(name, t -> t.lostFrom(from)).apply(r.edge(from)))
                            .about(name);
                });
    }
}
