package org.auvsim.viz.driving;

/**
 * Where somebody wants an object to go, as parts from -1 to 1 of what it can, in body axes.
 *
 * @param surge ahead
 * @param sway to port
 * @param heave up
 * @param yaw the bow to port
 * @param pitch the bow up
 */
public record Wanted(double surge, double sway, double heave, double yaw, double pitch) {
    /** To stay as it is. */
    public static final Wanted NOTHING = new Wanted(0, 0, 0, 0, 0);

    /** Both together, each part kept within -1 to 1. */
    public Wanted plus(Wanted other) {
        return new Wanted(
                within(surge + other.surge),
                within(sway + other.sway),
                within(heave + other.heave),
                within(yaw + other.yaw),
                within(pitch + other.pitch));
    }

    private static double within(double part) {
        return Math.clamp(part, -1, 1);
    }
}
