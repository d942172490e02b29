package org.auvsim.experiments.vehicle;

import org.auvsim.core.entity.Twist;
import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;

import java.util.OptionalDouble;

/**
 * How a vehicle at rest swings about a horizontal axis of its body, tried: undamped, with its added
 * mass, free to give way, wherever its origin is.
 */
final class SmallSwings {
    private static final double SMALL = 1e-3;
    private static final Twist REST = new Twist(Vec3.ZERO, Vec3.ZERO);

    private SmallSwings() {}

    /** Period (s) about a unit vector; empty if nothing turns it back. */
    static OptionalDouble period(WorldObjectDefinition vehicle, Vec3 axis) {
        double stiffness =
                (acceleration(vehicle, axis, -SMALL) - acceleration(vehicle, axis, SMALL))
                        / (2 * SMALL);
        return stiffness > 0
                ? OptionalDouble.of(2 * Math.PI / Math.sqrt(stiffness))
                : OptionalDouble.empty();
    }

    private static double acceleration(WorldObjectDefinition vehicle, Vec3 axis, double angle) {
        Vec3 half = axis.times(angle / 2);
        Quat inclined = new Quat(1, half.x(), half.y(), half.z()).normalized();
        return TestTank.accelerations(vehicle, inclined, REST).angularVelocity().dot(axis);
    }
}
