package org.auvsim.experiments.workload;

import org.auvsim.core.math.Vec3;

import java.util.SplittableRandom;
import java.util.function.BiConsumer;

/** Where spheres start, and where they are driven to: clusters of lattices. */
record Formation(int bodies, long seed, Targets targets) {
    /** The most bodies of a cluster. */
    private static final int CLUSTER = 100;

    private static final double CLUSTER_SPACING = 60;
    private static final double SPACING = 6;
    private static final double JITTER = 1e-6;

    /** Tells the place and the target (m, world) of each body in order. */
    void each(BiConsumer<Vec3, Vec3> tell) {
        SplittableRandom random = new SplittableRandom(seed);
        int clusters = (bodies + CLUSTER - 1) / CLUSTER;
        for (int c = 0; c < clusters; c++) {
            Vec3 origin = lattice(c, side(clusters)).times(CLUSTER_SPACING);
            int members = Math.min(CLUSTER, bodies - c * CLUSTER);
            for (int j = 0; j < members; j++) {
                Vec3 place = place(j, members).plus(jitter(random));
                tell.accept(origin.plus(place), origin.plus(targets.of(j, members)));
            }
        }
    }

    /** The place of a member about its cluster's origin. */
    private static Vec3 place(int member, int members) {
        double middle = (side(members) - 1) / 2.0;
        return lattice(member, side(members))
                .minus(new Vec3(middle, middle, middle))
                .times(SPACING);
    }

    private static Vec3 jitter(SplittableRandom random) {
        return new Vec3(
                random.nextDouble(-JITTER, JITTER),
                random.nextDouble(-JITTER, JITTER),
                random.nextDouble(-JITTER, JITTER));
    }

    /** Side of the smallest cube of so many cells. */
    private static int side(int cells) {
        int side = 1;
        while (side * side * side < cells) {
            side++;
        }
        return side;
    }

    /** Cell {@code index} of a cube, in x, y, z order: x runs quickest. */
    private static Vec3 lattice(int index, int side) {
        int x = index % side;
        int y = index / side % side;
        int z = index / (side * side);
        return new Vec3(x, y, z);
    }
}
