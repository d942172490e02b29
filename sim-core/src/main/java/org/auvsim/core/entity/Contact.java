package org.auvsim.core.entity;

import org.auvsim.core.math.Vec3;

/**
 * Two collidables that touch, as they were just before any response.
 *
 * @param time of the world (s)
 * @param point where they touch (m, world)
 * @param normal unit vector from {@code other} toward {@code self} (world)
 * @param self the one whose response is asked
 * @param other the one that it met
 */
public record Contact(double time, Vec3 point, Vec3 normal, Participant self, Participant other) {
    /** The same contact as the other one sees it. */
    public Contact flipped() {
        return new Contact(time, point, normal.negated(), /* self= */ other, /* other= */ self);
    }

    /**
     * How fast the two part along the normal (m/s); negative while they approach. Zero unless both
     * are bodies.
     */
    public double separationSpeed() {
        if (self.body().isEmpty() || other.body().isEmpty()) {
            return 0;
        }
        Vec3 mine = self.body().get().velocityAt(point);
        Vec3 its = other.body().get().velocityAt(point);
        return normal.dot(mine.minus(its));
    }
}
