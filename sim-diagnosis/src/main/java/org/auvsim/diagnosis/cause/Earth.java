package org.auvsim.diagnosis.cause;

/** What causes take for granted of where a body moves. */
public final class Earth {
    /** Standard gravity (m/s^2; CGPM 1901). */
    public static final double GRAVITY = 9.80665;

    private Earth() {}
}
