package org.auvsim.examples.field;

import org.auvsim.core.description.Unit;
import org.auvsim.core.entity.Current;
import org.auvsim.core.entity.Domain;
import org.auvsim.core.math.Vec3;

/**
 * Water that streams along a line, as from a sluice: fastest on the line, and by the share
 * exp(-(r/width)^2) at a distance r from it.
 *
 * @param point of the line (m, world)
 * @param velocity on the line, along it (m/s, world)
 * @param width (m), above 0
 */
public record Jet(
        long id,
        String name,
        @Unit("m") Vec3 point,
        @Unit("m/s") Vec3 velocity,
        @Unit("m") double width)
        implements Current {
    /**
     * A checked jet.
     *
     * @throws IllegalArgumentException if it has no direction or no width
     */
    public Jet {
        Domain.finite("jet '" + name + "'", "point", point, "m");
        Domain.above0("jet '" + name + "'", "speed", velocity.norm(), "m/s");
        Domain.above0("jet '" + name + "'", "width", width, "m");
    }

    @Override
    public Vec3 valueAt(Vec3 position, double time) {
        double distance = velocity.normalized().cross(position.minus(point)).norm() / width;
        return velocity.times(StrictMath.exp(-distance * distance));
    }
}
