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
    /** Primitive operations by which an object finds its octants, counted once by hand. */
    private static final int OCTANTS = 75;

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
        sets.count(13L * motion.size());
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
                sets.count(end - begin);
                sets.add(sets.scratch(end), begin, end);
            }
            return;
        }
        sets.count((OCTANTS + 8) * (long) (end - begin));
        double quarter = half / 2;
        int[] members = sets.scratch(2 * end);
        for (int k = begin; k < end; k++) {
            members[end + k - begin] = octants(sets.spheres(), 4 * members[k], x, y, z, quarter);
        }
        int free = end + (end - begin);
        for (int octant = 0; octant < 8; octant++) {
            int childEnd = collect(sets, begin, end, octant);
            double cx = (octant & 1) == 0 ? x - quarter : x + quarter;
            double cy = (octant & 2) == 0 ? y - quarter : y + quarter;
            double cz = (octant & 4) == 0 ? z - quarter : z + quarter;
            visit(sets, free, childEnd, depth + 1, cx, cy, cz, quarter);
        }
    }

    /** Which of the eight children a swept sphere touches, a bit each. */
    private static int octants(
            double[] spheres, int at, double x, double y, double z, double quarter) {
        double lowX = beyond(spheres[at], x - quarter, quarter);
        double highX = beyond(spheres[at], x + quarter, quarter);
        double lowY = beyond(spheres[at + 1], y - quarter, quarter);
        double highY = beyond(spheres[at + 1], y + quarter, quarter);
        double lowZ = beyond(spheres[at + 2], z - quarter, quarter);
        double highZ = beyond(spheres[at + 2], z + quarter, quarter);
        double reach = spheres[at + 3] * spheres[at + 3];
        int bits = 0;
        bits |= lowX + lowY + lowZ <= reach ? 1 : 0;
        bits |= highX + lowY + lowZ <= reach ? 2 : 0;
        bits |= lowX + highY + lowZ <= reach ? 4 : 0;
        bits |= highX + highY + lowZ <= reach ? 8 : 0;
        bits |= lowX + lowY + highZ <= reach ? 16 : 0;
        bits |= highX + lowY + highZ <= reach ? 32 : 0;
        bits |= lowX + highY + highZ <= reach ? 64 : 0;
        bits |= highX + highY + highZ <= reach ? 128 : 0;
        return bits;
    }

    /** Square of the distance of a coordinate from an interval about {@code middle}. */
    private static double beyond(double coordinate, double middle, double half) {
        double distance = Math.max(0, Math.abs(coordinate - middle) - half);
        return distance * distance;
    }

    /**
     * Copies the objects of a node that touch a child behind the node's objects and their bits;
     * returns where they end.
     */
    private static int collect(CollisionSets sets, int begin, int end, int octant) {
        int size = end - begin;
        int[] members = sets.scratch(end + 2 * size);
        int to = end + size;
        for (int k = begin; k < end; k++) {
            if ((members[end + k - begin] >> octant & 1) != 0) {
                members[to++] = members[k];
            }
        }
        return to;
    }
}
