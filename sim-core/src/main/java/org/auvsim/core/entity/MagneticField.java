package org.auvsim.core.entity;

import org.auvsim.core.math.Vec3;

/** A field of magnetic flux density (T, world frame); those of a world add up. */
public interface MagneticField extends Field<Vec3> {}
