package org.auvsim.core.entity;

import org.auvsim.core.math.Vec3;

/**
 * An entity that permeates the whole world and has a value anywhere in it (thesis, section 6.3).
 *
 * @param <T> what it is a field of: {@link Vec3} for a current or a magnetic field
 */
public interface Field<T> extends Entity {
    /** The value at a position (m, world) and a time (s). */
    T valueAt(Vec3 position, double time);
}
