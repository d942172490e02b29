package org.auvsim.examples.behavior;

import org.auvsim.core.description.Unit;
import org.auvsim.core.entity.Behavior;
import org.auvsim.core.entity.Frame;
import org.auvsim.core.entity.NamedForce;
import org.auvsim.core.entity.WorldObject;
import org.auvsim.core.math.Vec3;

/**
 * Holds its object at a depth below the surface z = 0: a controller with a proportional and a
 * derivative part, whose vertical force bears the behavior's name.
 *
 * @param depth (m, downward)
 * @param proportional force per metre off (N/m)
 * @param derivative force per speed (N s/m)
 */
public record KeepDepth(
        String name,
        @Unit("m") double depth,
        @Unit("N/m") double proportional,
        @Unit("N s/m") double derivative)
        implements Behavior {
    @Override
    public void act(double time, WorldObject self) {
        double off = -depth - self.position().z();
        double lift = proportional * off - derivative * self.velocity().z();
        self.applyForce(NamedForce.direct(name, Frame.WORLD, new Vec3(0, 0, lift)));
    }
}
