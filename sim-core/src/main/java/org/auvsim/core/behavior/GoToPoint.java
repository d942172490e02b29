package org.auvsim.core.behavior;

import org.auvsim.core.description.Default;
import org.auvsim.core.description.Unit;
import org.auvsim.core.entity.Behavior;
import org.auvsim.core.entity.Frame;
import org.auvsim.core.entity.NamedForce;
import org.auvsim.core.entity.WorldObject;
import org.auvsim.core.math.Vec3;

/**
 * Pushes its object toward a point with a force of constant size, and rests while the object is
 * within a radius of it (thesis, section 8.2). The force bears the behavior's name.
 *
 * @param force size of the push (N)
 * @param radius within which it does not push (m)
 * @param target (m, world)
 */
public record GoToPoint(
        String name,
        @Unit("N") double force,
        @Unit("m") @Default("0.1") double radius,
        @Unit("m") Vec3 target)
        implements Behavior {
    /**
     * A checked behavior.
     *
     * @throws IllegalArgumentException if force or radius is negative, or a number is not finite
     */
    public GoToPoint {
        if (!(force >= 0 && radius >= 0) || !Double.isFinite(force + radius)) {
            throw new IllegalArgumentException(
                    "force and radius of '%s' must be 0 or more, but are %s N and %s m"
                            .formatted(name, force, radius));
        }
    }

    @Override
    public void act(double time, WorldObject self) {
        Vec3 way = target.minus(self.position());
        double distance = way.norm();
        if (distance > radius) {
            Vec3 push = way.times(force / distance);
            self.applyForce(NamedForce.direct(name, Frame.WORLD, push));
        } else {
            self.removeForce(name);
        }
    }
}
