package org.auvsim.core.step;

import org.auvsim.core.description.Unit;

/**
 * Shortens the step to the smallest radius divided by a speed that nothing exceeds (thesis, section
 * 9.2): cheaper than looking at every object's path, as long as the promise holds.
 *
 * @param speed (m/s) above 0
 */
public record MaximumSpeedRestricter(@Unit("m/s") double speed) implements TimeStepRestricter {
    /** Who moves at just the stated speed exceeds it by rounding (relative). */
    private static final double ROUNDING = 1e-6;

    /**
     * For a stated speed.
     *
     * @throws IllegalArgumentException if the speed is not positive and finite
     */
    public MaximumSpeedRestricter {
        if (!(speed > 0) || Double.isInfinite(speed)) {
            throw new IllegalArgumentException(
                    "the maximum speed must be above 0 m/s and finite, but is " + speed + " m/s");
        }
    }

    @Override
    public double restrict(Motion motion, double wanted) {
        double dt = wanted;
        for (int i = 0; i < motion.size(); i++) {
            if (motion.radius(i, 0) > 0) {
                dt = Math.min(dt, motion.radius(i, 0) / speed);
            }
        }
        for (int i = 0; i < motion.size(); i++) {
            if (motion.displacement(i, dt) > speed * dt * (1 + ROUNDING)) {
                throw new StepException(
                        "'%s' (id %d) is faster at %s s than the maximum speed of %s m/s: it moves"
                                        .formatted(
                                                motion.collidable(i).name(),
                                                motion.collidable(i).id(),
                                                motion.time(),
                                                speed)
                                + " %s m in %s s; state a higher speed"
                                        .formatted(motion.displacement(i, dt), dt));
            }
        }
        return dt;
    }
}
