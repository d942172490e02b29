package org.auvsim.core.step;

/**
 * The search that the thesis began with (sections 5.1.3 and 9.2): under constant forces the squared
 * distance of two centres is a polynomial of degree 4 in time, and its minima tell whether the two
 * spheres meet. No contact of a pair that shares a set is too short for it.
 *
 * <p>It holds for spheres that neither turn nor have a force in their own axes or one that varies;
 * anything else is refused by name.
 */
public record AnalyticFinder() implements CollisionFinder {
    /**
     * {@inheritDoc}
     *
     * @throws StepException naming an object whose path or volume the formula does not cover
     */
    @Override
    public double earliest(Motion motion, CollisionSets sets, double dt) {
        Parabola[] paths = ParabolicPaths.of(motion, dt);
        double earliest = Double.POSITIVE_INFINITY;
        for (int k = 0; k < sets.pairCount(); k++) {
            int i = sets.first(k);
            int j = sets.second(k);
            earliest = Math.min(earliest, collision(motion, i, j, paths[i].minus(paths[j]), dt));
        }
        return earliest;
    }

    /** When a pair meets, at an instant where it overlaps and approaches; infinity if never. */
    private static double collision(Motion motion, int i, int j, Parabola apart, double dt) {
        if (motion.overlap(i, j, 0) && motion.approaching(i, j, 0)) {
            return 0;
        }
        double reach = motion.radius(i, 0) + motion.radius(j, 0);
        double[] extremes = apart.extremes(dt);
        double before = 0;
        for (double extreme : extremes) {
            double contact = apart.comesWithin(reach, before, extreme);
            if (contact <= extreme) {
                double seen = overlapFrom(motion, i, j, contact, extreme);
                if (seen <= extreme && motion.approaching(i, j, seen)) {
                    return seen;
                }
            }
            before = extreme;
        }
        return Double.POSITIVE_INFINITY;
    }

    /** The instant from {@code contact} on at which the integrated bodies overlap, rounded too. */
    private static double overlapFrom(Motion motion, int i, int j, double contact, double limit) {
        double instant = contact;
        double further = Math.ulp(limit);
        while (instant < limit && !motion.overlap(i, j, instant)) {
            instant = Math.min(limit, instant + further);
            further *= 2;
        }
        return motion.overlap(i, j, instant) ? instant : Double.POSITIVE_INFINITY;
    }
}
