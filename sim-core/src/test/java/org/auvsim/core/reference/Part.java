package org.auvsim.core.reference;

/**
 * All points within {@code radius} of a cuboid, whose edges may be 0 long: a ball is a point, a
 * capsule a line, a box a cuboid with radius 0. The reference knows no other convex volume.
 */
final class Part {
    final Placement inBody = new Placement();
    final double[] half;
    final double radius;

    /** Extends over the axes along which it has a length: vertices and edges by number. */
    private final int[] axes;

    private final Placement now = new Placement();
    final double[] vertices;
    final int[] edges;

    Part(double halfX, double halfY, double halfZ, double radius) {
        half = new double[] {halfX, halfY, halfZ};
        this.radius = radius;
        int dimension = 0;
        for (double h : half) {
            dimension += h > 0 ? 1 : 0;
        }
        axes = new int[dimension];
        int next = 0;
        for (int axis = 0; axis < 3; axis++) {
            if (half[axis] > 0) {
                axes[next++] = axis;
            }
        }
        vertices = new double[3 << dimension];
        edges = new int[dimension * (1 << dimension)];
        int edge = 0;
        for (int vertex = 0; vertex < 1 << dimension; vertex++) {
            for (int bit = 0; bit < dimension; bit++) {
                if ((vertex >> bit & 1) == 0) {
                    edges[edge++] = vertex;
                    edges[edge++] = vertex | 1 << bit;
                }
            }
        }
    }

    /** Half the length (m) of the longest line through it. */
    double reach() {
        return Math.sqrt(half[0] * half[0] + half[1] * half[1] + half[2] * half[2]) + radius;
    }

    /** Where its middle is now. */
    double[] middle() {
        return now.at;
    }

    /** Smaller by {@code margin} (m) on all sides: what lies deeper than that. */
    Part eroded(double margin) {
        Part part =
                radius > 0
                        ? new Part(half[0], half[1], half[2], radius - margin)
                        : new Part(half[0] - margin, half[1] - margin, half[2] - margin, 0);
        System.arraycopy(inBody.at, 0, part.inBody.at, 0, 3);
        System.arraycopy(inBody.turn, 0, part.inBody.turn, 0, 9);
        return part;
    }

    /** Moves with its body. */
    void follow(Placement body) {
        now.compose(body, inBody);
        for (int vertex = 0; vertex < vertices.length / 3; vertex++) {
            double[] corner = new double[3];
            for (int bit = 0; bit < axes.length; bit++) {
                int axis = axes[bit];
                corner[axis] = (vertex >> bit & 1) == 0 ? -half[axis] : half[axis];
            }
            now.outward(corner[0], corner[1], corner[2], vertices, 3 * vertex);
        }
    }

    /** Distance (m) of the middles less both reaches: a quick lower bound of the gap. */
    double roughGap(Part o) {
        double dx = now.at[0] - o.now.at[0];
        double dy = now.at[1] - o.now.at[1];
        double dz = now.at[2] - o.now.at[2];
        return Math.sqrt(dx * dx + dy * dy + dz * dz) - reach() - o.reach();
    }

    /** Distance (m) of a point from the cuboid without its radius; 0 inside. */
    double fromCore(double x, double y, double z) {
        double sum = 0;
        for (int axis = 0; axis < 3; axis++) {
            double out = Math.max(0, Math.abs(now.inward(axis, x, y, z)) - half[axis]);
            sum += out * out;
        }
        return Math.sqrt(sum);
    }

    /** Whether a line shares a point with the cuboid (clipping it by the three slabs). */
    boolean cutBy(double[] points, int a, int b) {
        double from = 0;
        double to = 1;
        for (int axis = 0; axis < 3; axis++) {
            double begin = now.inward(axis, points[a], points[a + 1], points[a + 2]);
            double way = now.inward(axis, points[b], points[b + 1], points[b + 2]) - begin;
            if (way == 0) {
                if (Math.abs(begin) > half[axis]) {
                    return false;
                }
            } else {
                double in = (-Math.copySign(half[axis], way) - begin) / way;
                double out = (Math.copySign(half[axis], way) - begin) / way;
                from = Math.max(from, in);
                to = Math.min(to, out);
            }
        }
        return from <= to;
    }
}
