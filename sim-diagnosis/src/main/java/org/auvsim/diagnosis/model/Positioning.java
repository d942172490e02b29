package org.auvsim.diagnosis.model;

import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.server.feedback.RigidMotion;

/**
 * Where sensors tell a body to be that is somewhere.
 *
 * @param arm from the body's origin to the point whose position is told (m, body)
 * @param scale of coordinates, less 1
 * @param offset by which positions are off (m)
 * @param drift by which positions run away from the run's beginning on (m/s); a part goes on with
 *     what it was there
 */
record Positioning(Vec3 arm, Vec3 scale, Vec3 offset, Vec3 drift) {
    /** Where it is. */
    static final Positioning EXACT = new Positioning(Vec3.ZERO, Vec3.ZERO, Vec3.ZERO, Vec3.ZERO);

    /** Both, one on top of the other. */
    Positioning plus(Positioning more) {
        return new Positioning(
                arm.plus(more.arm),
                scale.plus(more.scale),
                offset.plus(more.offset),
                drift.plus(more.drift));
    }

    /**
     * The place that is told of a motion, along axes of sensors, so long (s) after the beginning.
     */
    Vec3 place(RigidMotion of, Quat axes, double since) {
        Vec3 point = of.position().plus(of.orientation().rotate(arm));
        return axes.rotate(inScale(point)).plus(offset).plus(drift.times(since));
    }

    /** The velocity that is told along axes of sensors. */
    Vec3 velocity(Vec3 of, Quat axes) {
        return axes.rotate(inScale(of)).plus(drift);
    }

    private Vec3 inScale(Vec3 v) {
        return new Vec3(v.x() * (1 + scale.x()), v.y() * (1 + scale.y()), v.z() * (1 + scale.z()));
    }
}
