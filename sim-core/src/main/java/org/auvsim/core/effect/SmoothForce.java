package org.auvsim.core.effect;

import org.auvsim.core.entity.Effect;
import org.auvsim.core.math.Vec3;

/**
 * A force at a body's origin that place and time alone say, whatever the body is and does, and that
 * changes smoothly.
 */
public interface SmoothForce extends Effect {
    /** The force (N, world) at a place (m, world) and a time (s, the world's). */
    Vec3 at(Vec3 place, double time);
}
