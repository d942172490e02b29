package org.auvsim.core.actuator;

/** How hard a propulsor pushes at a level; an immutable value. */
public interface ThrustCurve {
    /** Thrust (N) at a level from -1 (full astern) to 1 (full ahead); 0 at level 0. */
    double thrust(double level);
}
