package org.auvsim.core.step;

/**
 * The thesis' default (section 5.1.1): halves the step until no object moves farther than its own
 * radius, that of its bounding sphere.
 */
public record RadiusDistanceRestricter() implements TimeStepRestricter {
    private static final int MOST_HALVINGS = 60;

    @Override
    public double restrict(Motion motion, double wanted) {
        double dt = wanted;
        int halvings = 0;
        for (int i = 0; i < motion.size(); i++) {
            while (motion.displacement(i, dt) > motion.radius(i, 0)) {
                if (motion.radius(i, 0) == 0 || ++halvings > MOST_HALVINGS) {
                    throw new StepException(
                            "the time step cannot be made short enough for '%s' (id %d) at %s s: in"
                                            .formatted(
                                                    motion.collidable(i).name(),
                                                    motion.collidable(i).id(),
                                                    motion.time())
                                    + " %s s it still moves %s m, more than its radius of %s m"
                                            .formatted(
                                                    dt,
                                                    motion.displacement(i, dt),
                                                    motion.radius(i, 0)));
                }
                dt /= 2;
            }
        }
        return dt;
    }
}
