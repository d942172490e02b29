package org.auvsim.core.entity;

import org.auvsim.core.math.Vec3;

/** A field of water velocity (m/s, world frame); the currents of a world add up. */
public interface Current extends Field<Vec3> {}
