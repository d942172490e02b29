package org.auvsim.examples.stage;

import org.auvsim.core.step.CollisionPartitioner;
import org.auvsim.core.step.CollisionSets;
import org.auvsim.core.step.Motion;

import java.util.Comparator;
import java.util.stream.IntStream;

/**
 * Sorts the swept spheres by where they begin along x, and sweeps: each one makes a set with every
 * later one that begins before it ends. Good where things stand in a row.
 */
public record SweepPartitioner() implements CollisionPartitioner {
    @Override
    public void partition(Motion motion, double dt, CollisionSets sets) {
        double[] spheres = sets.spheres();
        int[] order =
                IntStream.range(0, motion.size())
                        .boxed()
                        .sorted(Comparator.comparingDouble(i -> begin(spheres, i)))
                        .mapToInt(Integer::intValue)
                        .toArray();
        for (int a = 0; a < order.length; a++) {
            double end = spheres[4 * order[a]] + spheres[4 * order[a] + 3];
            for (int b = a + 1; b < order.length && begin(spheres, order[b]) <= end; b++) {
                sets.add(new int[] {order[a], order[b]}, 0, 2);
            }
        }
    }

    private static double begin(double[] spheres, int i) {
        return spheres[4 * i] - spheres[4 * i + 3];
    }
}
