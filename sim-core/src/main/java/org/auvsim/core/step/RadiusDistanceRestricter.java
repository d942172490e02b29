package org.auvsim.core.step;

/**
 * The thesis' default (section 5.1.1): halves the step until no object moves farther than its own
 * radius, that of its bounding sphere. What has no end, such as the ground, must not move.
 */
public record RadiusDistanceRestricter() implements TimeStepRestricter {
    private static final int MOST_HALVINGS = 60;

    @Override
    public double restrict(Motion motion, double wanted) {
        double dt = wanted;
        int halvings = 0;
        for (int i = 0; i < motion.size(); i++) {
            double radius = motion.radius(i, 0);
            double way = motion.displacement(i, dt);
            if (radius == Double.POSITIVE_INFINITY && way > 0) {
                throw endless(motion, i);
            }
            while (way > radius) {
                if (radius == 0 || ++halvings > MOST_HALVINGS) {
                    throw tooQuick(motion, i, dt);
                }
                dt /= 2;
                way = motion.displacement(i, dt);
            }
        }
        return dt;
    }

    private static StepException endless(Motion motion, int i) {
        return new StepException(
                "'%s' (id %d) moves at %s s, but has no radius to restrict the step by, as its volume"
                                .formatted(
                                        motion.collidable(i).name(),
                                        motion.collidable(i).id(),
                                        motion.time())
                        + " has no end; make it fixed or choose the maximum-speed restricter");
    }

    private static StepException tooQuick(Motion motion, int i, double dt) {
        return new StepException(
                "the time step cannot be made short enough for '%s' (id %d) at %s s: in"
                                .formatted(
                                        motion.collidable(i).name(),
                                        motion.collidable(i).id(),
                                        motion.time())
                        + " %s s it still moves %s m, more than its radius of %s m"
                                .formatted(dt, motion.displacement(i, dt), motion.radius(i, 0)));
    }
}
