package org.auvsim.core.reference;

/** A motion that is known without the engine; t counts from its beginning (s). */
interface Flight {
    /** Where it is; overwritten by the next call. */
    Placement at(double t);

    /** One component of the velocity of the origin (m/s). */
    double velocity(int axis, double t);

    /** An upper bound of the speed (m/s) of the origin in an interval. */
    double speedBound(double from, double to);

    /** An upper bound of the angular speed (rad/s). */
    double spinBound();
}
