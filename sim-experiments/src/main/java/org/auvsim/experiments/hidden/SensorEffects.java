package org.auvsim.experiments.hidden;

import org.apache.commons.math3.geometry.euclidean.threed.Vector3D;

import java.util.Map;

/** What sensors do that the model does not know. */
final class SensorEffects {
    private SensorEffects() {}

    static Family yawBias(Scene scene, Draws draws) {
        double sign = draws.sign();
        return Family.upTo(
                0.6,
                s ->
                        HiddenEffect.of(
                                "sensor_bias",
                                Map.of("yaw", Numbers.of(sign * s)),
                                r -> r.sensed(q -> yaw(q, sign * s, 0))));
    }

    static Family yawDrift(Scene scene, Draws draws) {
        double sign = draws.sign();
        return Family.upTo(
                0.05,
                s ->
                        HiddenEffect.of(
                                "sensor_drift",
                                Map.of("yaw_rate", Numbers.of(sign * s)),
                                r -> r.sensed(q -> yaw(q, 0, sign * s))));
    }

    private static Sensors yaw(Sensors q, double yaw, double rate) {
        return new Sensors(q.delay(), q.scale(), q.turn(), q.yaw() + yaw, q.yawRate() + rate);
    }

    static Family scale(Scene scene, Draws draws) {
        Vector3D along = draws.direction();
        return Family.upTo(
                0.4,
                s -> {
                    Vector3D scale = along.scalarMultiply(s);
                    return HiddenEffect.of(
                            "sensor_scale",
                            Map.of("scale", Numbers.of(new Vector3D(1, 1, 1).add(scale))),
                            r ->
                                    r.sensed(
                                            q ->
                                                    new Sensors(
                                                            q.delay(),
                                                            q.scale().add(scale),
                                                            q.turn(),
                                                            q.yaw(),
                                                            q.yawRate())));
                });
    }

    static Family delay(Scene scene, Draws draws) {
        return late("sensor_delay", "delay", 1);
    }

    /** A clock that is behind tells of a motion as of an earlier time. */
    static Family clockOffset(Scene scene, Draws draws) {
        return late("clock_offset", "offset", draws.sign());
    }

    private static Family late(String cause, String parameter, double sign) {
        return Family.upTo(
                0.6,
                s ->
                        HiddenEffect.of(
                                cause,
                                Map.of(parameter, Numbers.of(sign * s)),
                                r ->
                                        r.sensed(
                                                q ->
                                                        new Sensors(
                                                                q.delay() + sign * s,
                                                                q.scale(),
                                                                q.turn(),
                                                                q.yaw(),
                                                                q.yawRate()))));
    }

    static Family axisMisalignment(Scene scene, Draws draws) {
        Vector3D along = draws.direction();
        return Family.upTo(
                0.5,
                s -> {
                    Vector3D turn = along.scalarMultiply(s);
                    return HiddenEffect.of(
                            "axis_misalignment",
                            Map.of("turn", Numbers.of(turn)),
                            r ->
                                    r.sensed(
                                            q ->
                                                    new Sensors(
                                                            q.delay(),
                                                            q.scale(),
                                                            q.turn().add(turn),
                                                            q.yaw(),
                                                            q.yawRate())));
                });
    }
}
