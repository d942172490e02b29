package org.auvsim.core.behavior;

import org.auvsim.core.description.Default;
import org.auvsim.core.description.Unit;
import org.auvsim.core.entity.Behavior;
import org.auvsim.core.entity.Frame;
import org.auvsim.core.entity.NamedForce;
import org.auvsim.core.entity.WorldObject;
import org.auvsim.core.math.Vec3;

/**
 * Drives its object to and fro along a line through the world's origin (thesis, section 8.1):
 * beyond the limit on either side a constant force pushes it back, between the limits none does.
 * The force bears the behavior's name.
 *
 * @param force size of the push (N)
 * @param limit distance from the origin at which the push begins (m)
 * @param axis direction of the line (world; any length above 0)
 */
public record BackAndForth(
        String name, @Unit("N") double force, @Unit("m") double limit, @Default("0 1 0") Vec3 axis)
        implements Behavior {
    /**
     * A checked behavior, its axis normalised.
     *
     * @throws IllegalArgumentException if force or limit is negative or not finite, or the axis is
     *     the zero vector
     */
    public BackAndForth {
        if (!(force >= 0 && limit >= 0) || !Double.isFinite(force + limit)) {
            throw new IllegalArgumentException(
                    "force and limit of '%s' must be 0 or more, but are %s N and %s m"
                            .formatted(name, force, limit));
        }
        if (Math.abs(axis.dot(axis) - 1) > 1e-15) {
            axis = axis.normalized();
        }
    }

    @Override
    public void act(double time, WorldObject self) {
        double along = axis.dot(self.position());
        if (Math.abs(along) > limit) {
            Vec3 push = axis.times(-Math.copySign(force, along));
            self.applyForce(NamedForce.direct(name, Frame.WORLD, push));
        } else {
            self.removeForce(name);
        }
    }
}
