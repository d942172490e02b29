package org.auvsim.viz.driving;

/**
 * How the sticks of a gamepad stand: -1 to 1, to the right and down positive; the triggers 0 to 1.
 */
public record Sticks(
        double leftX,
        double leftY,
        double rightX,
        double rightY,
        double leftTrigger,
        double rightTrigger) {
    /** A stick this near to its middle is in it. */
    static final double DEAD_ZONE = 0.1;

    /**
     * What they ask for: the left stick ahead and about, the right stick up and aside, the right
     * trigger the bow up and the left one down.
     */
    public Wanted wanted() {
        return new Wanted(
                -live(leftY),
                -live(rightX),
                -live(rightY),
                -live(leftX),
                live(rightTrigger) - live(leftTrigger));
    }

    private static double live(double axis) {
        double beyond = (Math.abs(axis) - DEAD_ZONE) / (1 - DEAD_ZONE);
        return beyond <= 0 ? 0.0 : Math.copySign(Math.min(beyond, 1), axis);
    }
}
