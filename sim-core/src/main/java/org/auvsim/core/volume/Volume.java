package org.auvsim.core.volume;

import org.auvsim.core.math.Mat3;
import org.auvsim.core.math.Vec3;

/**
 * A solid of constant density, in body coordinates, with its centre of mass at the origin.
 *
 * <p>A volume of a user's own implements this and registers a {@link PairQuery} with each kind of
 * volume that it is to meet.
 */
public interface Volume {
    /** Radius (m) of the smallest sphere about the origin that holds the volume. */
    double boundingRadius();

    /** Inertia tensor about the origin (kg m^2) of this volume with {@code mass} (kg). */
    Mat3 inertia(double mass);

    /** Whether a point (m, body coordinates) lies inside or on the surface. */
    boolean contains(Vec3 point);
}
