package org.auvsim.core.step;

import org.auvsim.core.description.Default;

/**
 * The thesis' default (section 5.1.2; Ganovelli et al. 2000): a cube that holds everything is split
 * into eight while it has more than {@code maximumObjectsPerNode} objects, down to {@code
 * maximumDepth}; the leaves are the collision sets. An object is in every leaf that its swept
 * sphere touches.
 */
public record OctreePartitioner(
        @Default("6") int maximumDepth, @Default("8") int maximumObjectsPerNode)
        implements CollisionPartitioner {
    /**
     * With limits.
     *
     * @throws IllegalArgumentException if the depth is not 0 to 20 or the number below 1
     */
    public OctreePartitioner {
        if (maximumDepth < 0 || maximumDepth > 20) {
            throw new IllegalArgumentException(
                    "an octree's maximum depth must be 0 to 20, but is " + maximumDepth);
        }
        if (maximumObjectsPerNode < 1) {
            throw new IllegalArgumentException(
                    "an octree's maximum of objects per node must be 1 or more, but is "
                            + maximumObjectsPerNode);
        }
    }

    /** Depth 6, 8 objects a node: the thesis leaves both to the user. */
    public static OctreePartitioner standard() {
        return new OctreePartitioner(6, 8);
    }

    @Override
    public void partition(Motion motion, double dt, CollisionSets sets) {
        if (motion.size() == 0) {
            return;
        }
        double[] spheres = sets.spheres();
        double[] low = {Double.MAX_VALUE, Double.MAX_VALUE, Double.MAX_VALUE};
        double[] high = {-Double.MAX_VALUE, -Double.MAX_VALUE, -Double.MAX_VALUE};
        int[] all = sets.scratch(motion.size());
        for (int i = 0; i < motion.size(); i++) {
            all[i] = i;
            for (int axis = 0; axis < 3; axis++) {
                low[axis] = Math.min(low[axis], spheres[4 * i + axis] - spheres[4 * i + 3]);
                high[axis] = Math.max(high[axis], spheres[4 * i + axis] + spheres[4 * i + 3]);
            }
        }
        double half = 0;
        for (int axis = 0; axis < 3; axis++) {
            half = Math.max(half, (high[axis] - low[axis]) / 2);
        }
        double x = (low[0] + high[0]) / 2;
        double y = (low[1] + high[1]) / 2;
        double z = (low[2] + high[2]) / 2;
        visit(sets, 0, motion.size(), 0, x, y, z, half);
    }

    /**
     * Visits the node whose objects are {@code scratch[begin]} to {@code scratch[end - 1]}; those
     * of its children stand behind them while they are visited.
     */
    private void visit(
            CollisionSets sets,
            int begin,
            int end,
            int depth,
            double x,
            double y,
            double z,
            double half) {
        if (end - begin <= maximumObjectsPerNode || depth == maximumDepth) {
            if (end > begin) {
                sets.add(sets.scratch(end), begin, end);
            }
            return;
        }
        double quarter = half / 2;
        for (int octant = 0; octant < 8; octant++) {
            double cx = (octant & 1) == 0 ? x - quarter : x + quarter;
            double cy = (octant & 2) == 0 ? y - quarter : y + quarter;
            double cz = (octant & 4) == 0 ? z - quarter : z + quarter;
            int childEnd = collect(sets, begin, end, cx, cy, cz, quarter);
            visit(sets, end, childEnd, depth + 1, cx, cy, cz, quarter);
        }
    }

    /** Copies the objects that touch a child's cube behind those of the node. */
    private static int collect(
            CollisionSets sets, int begin, int end, double x, double y, double z, double half) {
        int[] members = sets.scratch(end + (end - begin));
        int to = end;
        for (int k = begin; k < end; k++) {
            if (touches(sets.spheres(), 4 * members[k], x, y, z, half)) {
                members[to++] = members[k];
            }
        }
        return to;
    }

    private static boolean touches(
            double[] spheres, int at, double x, double y, double z, double half) {
        double dx = Math.max(0, Math.abs(spheres[at] - x) - half);
        double dy = Math.max(0, Math.abs(spheres[at + 1] - y) - half);
        double dz = Math.max(0, Math.abs(spheres[at + 2] - z) - half);
        return dx * dx + dy * dy + dz * dz <= spheres[at + 3] * spheres[at + 3];
    }
}
